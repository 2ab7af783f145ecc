//! Work on several processors whose results come in the order of the items.

use std::{
    collections::VecDeque,
    num::NonZero,
    sync::{
        Mutex, PoisonError,
        mpsc::{self, Receiver, Sender},
    },
    thread,
};

/// How many items a processor may be ahead of the result that is waited for. It bounds the memory, and evens out items that
/// take long.
const AHEAD: usize = 8;

/// An item, and where its result goes.
type Job<T, R> = (T, Sender<R>);

/// Does `work` on each item and hands the results to `consume` on this thread, in the order of the items, until `consume`
/// fails.
pub(crate) fn in_order<T: Send, R: Send, E>(
    items: impl IntoIterator<Item = T>,
    work: impl Fn(T) -> R + Sync,
    mut consume: impl FnMut(R) -> Result<(), E>,
) -> Result<(), E> {
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    let (jobs, queue) = mpsc::channel::<Job<T, R>>();
    let queue = Mutex::new(queue);
    thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| work_off(&queue, &work));
        }
        // Dropped when `consume` fails, so that the workers find nothing more to do.
        let jobs = jobs;
        let mut results = VecDeque::new();
        for item in items {
            if results.len() == workers * AHEAD {
                next(&mut results).map_or(Ok(()), &mut consume)?;
            }
            let (answer, result) = mpsc::channel();
            // The workers listen as long as this scope runs.
            let _ = jobs.send((item, answer));
            results.push_back(result);
        }
        while let Some(result) = next(&mut results) {
            consume(result)?;
        }
        Ok(())
    })
}

/// Takes one job after the other until there will be none.
fn work_off<T, R>(queue: &Mutex<Receiver<Job<T, R>>>, work: &impl Fn(T) -> R) {
    let take = || queue.lock().unwrap_or_else(PoisonError::into_inner).recv();
    while let Ok((item, answer)) = take() {
        // Nobody waits for it when `consume` has failed.
        let _ = answer.send(work(item));
    }
}

/// Waits for the oldest result. There is none when its worker panicked; the scope passes that on.
fn next<R>(results: &mut VecDeque<Receiver<R>>) -> Option<R> {
    results.pop_front()?.recv().ok()
}

#[cfg(test)]
mod tests {
    use std::{
        sync::atomic::{AtomicUsize, Ordering},
        thread,
        time::Duration,
    };

    use super::{AHEAD, in_order};

    #[test]
    fn results_come_in_order_however_long_each_takes() {
        let mut seen = Vec::new();
        let slow_first = |number: u64| {
            thread::sleep(Duration::from_millis(3 * u64::from(number.is_multiple_of(7))));
            number * 2
        };
        let outcome: Result<(), ()> = in_order(0..100, slow_first, |number| {
            seen.push(number);
            Ok(())
        });
        assert_eq!(outcome, Ok(()));
        assert_eq!(seen, (0..100).map(|number| number * 2).collect::<Vec<_>>());
    }

    #[test]
    fn no_more_results_than_a_few_a_processor_are_held() {
        let held = AtomicUsize::new(0);
        let most = AtomicUsize::new(0);
        let work = |()| {
            let now = held.fetch_add(1, Ordering::SeqCst) + 1;
            most.fetch_max(now, Ordering::SeqCst);
        };
        let consume = |()| {
            held.fetch_sub(1, Ordering::SeqCst);
            Ok::<(), ()>(())
        };
        assert_eq!(in_order([(); 5_000], work, consume), Ok(()));
        let workers = thread::available_parallelism().map_or(1, std::num::NonZero::get);
        assert!(most.into_inner() <= workers * (AHEAD + 1));
    }

    #[test]
    fn nothing_more_is_asked_for_after_a_failure() {
        let mut given = 0;
        let items = std::iter::repeat_with(|| given += 1).take(10_000);
        let outcome = in_order(items, |()| (), |()| Err("disk full"));
        assert_eq!(outcome, Err("disk full"));
        assert!(given < 10_000, "{given}");
    }
}
