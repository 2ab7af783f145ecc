//! Random dialogues: the server against a model, and frames that nobody would send.

use std::collections::BTreeMap;

use lexican_runtime::{
    AbortCode, Address, CanId, Frame, NmtState,
    od::{Access, DataType},
};
use lexican_tests::{
    bus::Bus,
    client::{Manner, download, upload, upload_blocks},
    sample::quiet,
    simulated::{Object, Simulated},
};
use proptest::{prelude::*, sample::select, test_runner::TestRunner};

/// The objects of the model: a number of each length, a string, one that is read only, one that is written only.
const TYPES: [(u16, DataType, usize, Access); 11] = [
    (0x2000, DataType::UNSIGNED8, 1, RW),
    (0x2001, DataType::INTEGER16, 2, RW),
    (0x2002, DataType::UNSIGNED24, 3, RW),
    (0x2003, DataType::INTEGER32, 4, RW),
    (0x2004, DataType::INTEGER40, 5, RW),
    (0x2005, DataType::TIME_DIFFERENCE, 6, RW),
    (0x2006, DataType::UNSIGNED56, 7, RW),
    (0x2007, DataType::REAL64, 8, RW),
    (0x2008, DataType::OCTET_STRING, 30, RW),
    (0x2009, DataType::UNSIGNED16, 2, Access::READ),
    (0x200A, DataType::UNSIGNED16, 2, Access::WRITE),
];
const RW: Access = Access::READ.with(Access::WRITE);

/// What the dictionary holds, as simply as it can be said.
struct Model(BTreeMap<u16, Vec<u8>>);

impl Model {
    fn read(&self, index: u16) -> Result<Vec<u8>, AbortCode> {
        match facts(index) {
            None => Err(AbortCode::NO_SUCH_OBJECT),
            Some((.., access)) if !access.has(Access::READ) => Err(AbortCode::WRITE_ONLY),
            Some(_) => Ok(self.0[&index].clone()),
        }
    }

    fn write(&mut self, index: u16, value: &[u8]) -> Result<(), AbortCode> {
        let (data_type, length) = match facts(index) {
            None => return Err(AbortCode::NO_SUCH_OBJECT),
            Some((.., access)) if !access.has(Access::WRITE) => return Err(AbortCode::READ_ONLY),
            Some((data_type, length, _)) => (data_type, length),
        };
        if value.len() > length {
            return Err(AbortCode::TOO_LONG);
        }
        if value.len() < length && data_type != DataType::OCTET_STRING {
            return Err(AbortCode::TOO_SHORT);
        }
        self.0.insert(index, value.to_vec());
        Ok(())
    }
}

fn facts(index: u16) -> Option<(DataType, usize, Access)> {
    let (_, data_type, length, access) = TYPES.into_iter().find(|facts| facts.0 == index)?;
    Some((data_type, length, access))
}

fn model_and_bus() -> (Model, Bus<Simulated>) {
    let default = |data_type, length| vec![0; if data_type == DataType::OCTET_STRING { 0 } else { length }];
    let object = |(index, data_type, length, access)| Object {
        address: Address::new(index, 0),
        data_type,
        access,
        default: default(data_type, length),
        limits: None,
        capacity: if data_type == DataType::OCTET_STRING { length } else { 0 },
    };
    let model = TYPES
        .into_iter()
        .map(|(index, data_type, length, _)| (index, default(data_type, length)));
    (
        Model(model.collect()),
        Bus::booted(Simulated::new(&TYPES.map(object)), 1),
    )
}

#[derive(Clone, Debug)]
enum Action {
    Read(u16),
    ReadBlocks(u16, u8, usize),
    Write(u16, Vec<u8>, Manner),
}

fn action() -> impl Strategy<Value = Action> {
    let index = 0x2000..=0x200Bu16;
    let manner = prop_oneof![
        Just(Manner::Expedited),
        (1..=7usize, any::<bool>()).prop_map(|(step, announced)| Manner::Segmented { step, announced }),
        (any::<bool>(), 0..8usize).prop_map(|(announced, lost)| Manner::Block { announced, lost }),
    ];
    prop_oneof![
        index.clone().prop_map(Action::Read),
        (index.clone(), 1..=6u8, 0..8usize).prop_map(|(index, size, lost)| Action::ReadBlocks(index, size, lost)),
        (index, proptest::collection::vec(any::<u8>(), 0..34), manner).prop_map(|(index, mut value, manner)| {
            // Most values have the right length, or nothing would ever be stored.
            let length = facts(index).map_or(2, |facts| facts.1);
            if value.len() % 4 != 0 && length <= 8 {
                value.resize(length, 0x5A);
            }
            if manner == Manner::Expedited {
                value.resize(value.len().clamp(1, 4), 0);
            }
            Action::Write(index, value, manner)
        }),
    ]
}

#[test]
fn the_dictionary_is_what_the_client_made_of_it() {
    let dialogues = proptest::collection::vec(action(), 1..40);
    let mut runner = TestRunner::deterministic();
    let outcome = runner.run(&dialogues, |actions| {
        let (mut model, mut bus) = model_and_bus();
        for action in actions {
            match action {
                Action::Read(index) => {
                    prop_assert_eq!(upload(&mut bus, Address::new(index, 0)), model.read(index));
                }
                Action::ReadBlocks(index, block_size, lost) => {
                    let read = upload_blocks(&mut bus, Address::new(index, 0), block_size, lost);
                    prop_assert_eq!(read, model.read(index), "{:04X}h in blocks of {}", index, block_size);
                }
                Action::Write(index, value, manner) => {
                    let written = download(&mut bus, Address::new(index, 0), &value, manner);
                    prop_assert_eq!(written, model.write(index, &value), "{:04X}h {:?}", index, manner);
                }
            }
        }
        Ok(())
    });
    outcome.unwrap();
}

/// Frames that are close to what a node listens to, and some that are not.
fn frame() -> impl Strategy<Value = Frame> {
    let id = prop_oneof![8 => Just(0x601), 1 => Just(0x000), 1 => 0..=0x7FFu32];
    let command = select(vec![
        0x00, 0x10, 0x0D, 0x20, 0x21, 0x22, 0x2F, 0x23, 0x40, 0x60, 0x70, 0x80, 0x01, 0x02, 0x81,
    ]);
    let index = select(vec![0x1000u16, 0x1008, 0x1017, 0x2002, 0x2009, 0x200A, 0x6004]);
    let likely = (command, index, any::<[u8; 5]>()).prop_map(|(command, index, [_, d @ ..])| {
        let [low, high] = index.to_le_bytes();
        vec![command, low, high, 0, d[0], d[1] & 1, 0, 0]
    });
    let data = prop_oneof![
        4 => likely,
        1 => any::<[u8; 8]>().prop_map(Vec::from),
        1 => proptest::collection::vec(any::<u8>(), 0..=8),
        1 => select(vec![vec![0x01, 0x01], vec![0x02, 0x01], vec![0x80, 0x01], vec![0x81, 0x00], vec![0x82, 0x01]]),
    ];
    (id, data).prop_map(|(id, data)| Frame::new(CanId::standard(id).expect("11 bits"), &data).expect("8 bytes"))
}

#[test]
fn whatever_comes_a_request_has_one_answer_at_most_and_stopped_has_none() {
    let dialogues = proptest::collection::vec((frame(), 0..1500u64), 1..120);
    let mut runner = TestRunner::deterministic();
    let outcome = runner.run(&dialogues, |dialogue| {
        let mut bus = Bus::booted(quiet(), 1);
        for (frame, pause) in dialogue {
            let state = bus.node().state();
            bus.put(frame);
            let answers = sdo_answers(&mut bus);
            let asked = frame.id() == CanId::standard(0x601).unwrap() && frame.length() == 8;
            prop_assert!(
                answers.len() <= usize::from(asked),
                "{frame:?} was answered {answers:?}"
            );
            prop_assert!(
                state != NmtState::Stopped || answers.is_empty(),
                "{answers:?} in STOPPED"
            );
            bus.advance(pause);
            for answer in sdo_answers(&mut bus) {
                let timed_out = answer.data().ends_with(&[0x00, 0x00, 0x04, 0x05]);
                prop_assert!(timed_out, "{answer:?} came by itself");
            }
        }
        Ok(())
    });
    outcome.unwrap();
}

/// What the node has sent; all of it is an SDO response, a boot-up message or a heartbeat.
fn sdo_answers<D: lexican_runtime::Device>(bus: &mut Bus<D>) -> Vec<Frame> {
    let sent: Vec<Frame> = std::iter::from_fn(|| bus.take()).collect();
    let (answers, others): (Vec<Frame>, Vec<Frame>) = sent.into_iter().partition(|frame| frame.length() == 8);
    assert!(answers.iter().all(|frame| frame.id().number() == 0x581), "{answers:?}");
    assert!(
        others
            .iter()
            .all(|frame| frame.id().number() == 0x701 && frame.length() == 1),
        "{others:?}"
    );
    answers
}
