//! The client: one transfer at a time, its attempts and its time.

use std::collections::VecDeque;
use std::time::Duration;

use lexican_runtime::{AbortCode, Address, Frame, Instant};

use super::{
    Channel, Failure,
    attempt::{Attempt, BLOCKS_PAY, Job, Opening, abort},
    step::Step,
};

/// How long a client waits, and how often it tries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// The longest wait for one answer.
    pub timeout: Duration,
    /// How often a transfer is tried that gets no answer or a broken one, at least 1.
    ///
    /// A value that is written twice because the confirmation was lost is the same value; an object for which that matters is
    /// written with one attempt.
    pub attempts: u8,
}

impl Default for Patience {
    /// Half a second, twice.
    fn default() -> Self {
        Self {
            timeout: Duration::from_millis(500),
            attempts: 2,
        }
    }
}

/// How a value is transferred.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Manner {
    /// Expedited or in segments: what every server knows.
    Plain,
    /// In blocks.
    Block,
    /// In blocks from 64 bytes on or when the server does not say how many there are, and plain when it refuses blocks. It is
    /// asked for them only until it refuses.
    #[default]
    Fastest,
}

/// An SDO client, sans-IO.
///
/// Begin a transfer, then send what [`Client::poll`] gives, hand over each frame that comes, and poll again at
/// [`Client::poll_at`]; [`Client::outcome`] has the end.
///
/// ```
/// use lexican_bus::sdo::{Channel, Client, Manner, Patience};
/// use lexican_runtime::{Address, CanId, Frame, Instant, NodeId};
///
/// let node_id = NodeId::new(5).unwrap();
/// let now = Instant::from_millis(0);
/// let mut client = Client::new(Channel::default_of(node_id), Patience::default());
/// client.upload(now, Address::new(0x1000, 0), Manner::Fastest);
/// assert_eq!(format!("{:?}", client.poll(now).unwrap()), "605#4000100000000000");
///
/// let answer = [0x43, 0x00, 0x10, 0x00, 0x96, 0x01, 0x02, 0x00];
/// client.receive(now, &Frame::full(CanId::sdo_response(node_id), answer));
/// assert_eq!(client.outcome(), Some(Ok(vec![0x96, 0x01, 0x02, 0x00])));
/// ```
#[derive(Clone, Debug)]
pub struct Client {
    channel: Channel,
    patience: Patience,
    running: Option<Running>,
    sending: VecDeque<[u8; 8]>,
    outcome: Option<Result<Vec<u8>, Failure>>,
    /// Whether the server has refused blocks.
    blocks_refused: bool,
}

#[derive(Clone, Debug)]
struct Running {
    job: Job,
    manner: Manner,
    attempt: Attempt,
    /// Attempts that are left.
    left: u8,
    deadline: Instant,
}

impl Client {
    /// A client that has nothing to do yet.
    #[must_use]
    pub const fn new(channel: Channel, patience: Patience) -> Self {
        Self {
            channel,
            patience,
            running: None,
            sending: VecDeque::new(),
            outcome: None,
            blocks_refused: false,
        }
    }

    /// Begins to read the value at `address`. A transfer under way is given up.
    pub fn upload(&mut self, now: Instant, address: Address, manner: Manner) {
        self.begin(now, Job { address, value: None }, manner);
    }

    /// Begins to write `value` to `address`. A transfer under way is given up.
    pub fn download(&mut self, now: Instant, address: Address, value: Vec<u8>, manner: Manner) {
        let value = Some(value);
        self.begin(now, Job { address, value }, manner);
    }

    /// Takes a frame from the bus; those that are not for this client, too.
    pub fn receive(&mut self, now: Instant, frame: &Frame) {
        let Some(mut running) = self.running.take() else {
            return;
        };
        let boot_up = Frame::byte(self.channel.error_control, 0);
        if *frame == boot_up {
            return self.fail(now, running, Failure::Rebooted);
        }
        let ours = (frame.data_id() == Some(self.channel.response)).then(|| frame.full_data());
        match ours.flatten() {
            Some(bytes) => {
                let step = running.attempt.receive(bytes);
                self.take(now, running, step);
            }
            None => self.running = Some(running),
        }
    }

    /// What is to be sent next; to be asked until it is `None`, after each call of another method and at
    /// [`Client::poll_at`].
    pub fn poll(&mut self, now: Instant) -> Option<Frame> {
        if self.sending.is_empty() {
            self.keep_time(now);
        }
        let bytes = self.sending.pop_front()?;
        if let Some(running) = &mut self.running {
            running.deadline = after(now, self.patience.timeout);
        }
        Some(Frame::full(self.channel.request, bytes))
    }

    /// When the wait for an answer ends; `None` when none is waited for.
    #[must_use]
    pub fn poll_at(&self) -> Option<Instant> {
        self.running.as_ref().map(|running| running.deadline)
    }

    /// How the transfer ended, told once: the value that was read, nothing for one that was written.
    pub fn outcome(&mut self) -> Option<Result<Vec<u8>, Failure>> {
        self.outcome.take()
    }

    /// Gives the transfer under way up, and tells the server so with `code`.
    pub fn give_up(&mut self, code: AbortCode) {
        if let Some(running) = self.running.take() {
            self.sending.clear();
            self.sending.push_back(abort(running.job.address, code));
        }
    }

    fn begin(&mut self, now: Instant, job: Job, manner: Manner) {
        self.give_up(AbortCode::GENERAL);
        self.outcome = None;
        let (attempt, request) = Attempt::open(&job, self.opening(manner, &job));
        self.sending.push_back(request);
        self.running = Some(Running {
            job,
            manner,
            attempt,
            left: self.patience.attempts.saturating_sub(1),
            deadline: after(now, self.patience.timeout),
        });
    }

    fn opening(&self, manner: Manner, job: &Job) -> Opening {
        let length = job.value.as_ref().map(Vec::len);
        match (manner, length) {
            (Manner::Plain, _) => Opening::Plain,
            (Manner::Fastest, _) if self.blocks_refused => Opening::Plain,
            (Manner::Fastest, Some(length)) if length < BLOCKS_PAY as usize => Opening::Plain,
            (Manner::Block, _) | (Manner::Fastest, Some(_)) => Opening::Block,
            (Manner::Fastest, None) => Opening::Adaptive,
        }
    }

    /// Does what a state made of an answer.
    fn take(&mut self, now: Instant, mut running: Running, step: Step) {
        match step {
            Step::PassOver => self.running = Some(running),
            Step::Wait => self.wait(now, running),
            Step::Send(messages) => {
                self.sending = messages.into();
                self.wait(now, running);
            }
            Step::ToBlocks => {
                let given_up = abort(running.job.address, AbortCode::GENERAL);
                let (attempt, request) = Attempt::open(&running.job, Opening::Block);
                self.sending = [given_up, request].into();
                running.attempt = attempt;
                self.wait(now, running);
            }
            Step::Done(value) => self.outcome = Some(Ok(value)),
            Step::Last(message, value) => {
                self.sending.push_back(message);
                self.outcome = Some(Ok(value));
            }
            Step::Refused(code) => self.on_refusal(now, running, code),
            Step::Broken(code) => self.fail(now, running, Failure::Broken(code)),
        }
    }

    fn wait(&mut self, now: Instant, mut running: Running) {
        running.deadline = after(now, self.patience.timeout);
        self.running = Some(running);
    }

    /// Ends a wait that took too long.
    fn keep_time(&mut self, now: Instant) {
        let Some(mut running) = self.running.take_if(|running| running.deadline <= now) else {
            return;
        };
        if let Some(step) = running.attempt.on_silence() {
            return self.take(now, running, step);
        }
        let awaited = running.attempt.awaited();
        self.fail(now, running, Failure::Silent { awaited });
    }

    /// The refusal of blocks is none of the value.
    fn on_refusal(&mut self, now: Instant, running: Running, code: AbortCode) {
        let is_of_blocks = running.job.value.is_none() || code == AbortCode::UNKNOWN_COMMAND;
        if running.manner == Manner::Fastest && running.attempt.awaits_blocks() && is_of_blocks {
            return self.without_blocks(now, running);
        }
        self.sending.clear();
        self.outcome = Some(Err(Failure::Refused(code)));
    }

    /// Tries again, or ends the transfer.
    fn fail(&mut self, now: Instant, running: Running, failure: Failure) {
        self.sending.clear();
        if let Some(code) = abort_code(failure) {
            self.sending.push_back(abort(running.job.address, code));
        }
        if running.manner == Manner::Fastest && running.attempt.awaits_blocks() {
            self.without_blocks(now, running);
        } else if running.left > 0 {
            let left = running.left - 1;
            self.reopen(now, Running { left, ..running });
        } else {
            self.outcome = Some(Err(failure));
        }
    }

    fn without_blocks(&mut self, now: Instant, running: Running) {
        self.blocks_refused = true;
        self.reopen(now, running);
    }

    fn reopen(&mut self, now: Instant, mut running: Running) {
        let opening = self.opening(running.manner, &running.job);
        let (attempt, request) = Attempt::open(&running.job, opening);
        self.sending.push_back(request);
        running.attempt = attempt;
        self.wait(now, running);
    }
}

/// What the server is told; nothing when it has forgotten the transfer itself.
const fn abort_code(failure: Failure) -> Option<AbortCode> {
    match failure {
        Failure::Silent { .. } => Some(AbortCode::TIMED_OUT),
        Failure::Broken(code) => Some(code),
        Failure::Refused(_) | Failure::Rebooted => None,
    }
}

fn after(now: Instant, wait: Duration) -> Instant {
    now.plus_micros(u64::try_from(wait.as_micros()).unwrap_or(u64::MAX))
}
