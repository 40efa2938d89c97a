//! Cases one after the other, or two at a time.

use crate::event::{Event, Failure, Phase};
use crate::row::Row;
use crate::study::Study;
use regge_curvature::Error;
use std::collections::{BTreeMap, VecDeque};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::thread;

/// How many cases are computed at once. Rows and what observers see of them are the same, but for the seconds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// One after the other.
    Single,
    /// Two, from both ends of the list: for a study of cases that leave a processor idle, see [`Study::side_by_side`].
    Double,
}

/// The work, see [`Study::work`], of the largest case that is worth a neighbour: it takes seconds, and much of that time one thread
/// factorises. Larger ones have all threads to themselves.
const SMALL: u64 = 60_000_000;

/// The cases that nobody has begun, by their places in the study.
type Waiting = Mutex<VecDeque<usize>>;

/// A case's place and its rows.
type Finished = (usize, Result<Vec<Row>, Error>);

fn take<T>(waiting: &Waiting, from: impl FnOnce(&mut VecDeque<usize>) -> T) -> T {
    from(&mut waiting.lock().unwrap_or_else(PoisonError::into_inner))
}

impl Study {
    /// The memory in bytes that two cases at once take at most; None if one is so large that it should be alone.
    pub fn side_by_side(&self) -> Option<f64> {
        let small = self.cases.iter().all(|&case| self.work(case) <= SMALL);
        let mut needs: Vec<f64> = self.cases.iter().map(|&case| self.memory(case)).collect();
        needs.sort_by(|a, b| b.total_cmp(a));
        small.then(|| needs.iter().take(2).sum())
    }

    /// Computes the rows that are not among those of an earlier run, which the observer sees in their places.
    ///
    /// # Errors
    /// As [`Study::run`].
    pub fn resume(
        &self,
        earlier: &[Row],
        pace: Pace,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Vec<Row>, Failure> {
        self.check()
            .map_err(|error| Failure { case: None, error })?;
        let waiting = Mutex::new((0..self.cases.len()).collect());
        let (sender, receiver) = channel();
        thread::scope(|scope| {
            let waiting = &waiting;
            if pace == Pace::Double {
                scope.spawn(move || self.backwards(earlier, waiting, &sender));
            }
            let rows = self.forwards(earlier, waiting, &receiver, observe);
            // After a failure nothing more is begun.
            take(waiting, VecDeque::clear);
            rows
        })
    }

    /// Computes the last case of those that wait, until none does.
    fn backwards(&self, earlier: &[Row], waiting: &Waiting, finished: &Sender<Finished>) {
        while let Some(place) = take(waiting, VecDeque::pop_back) {
            let mut rows = Vec::new();
            let result = self.run_case(self.cases[place], earlier, &mut rows, &mut |_| ());
            let told = finished.send((place, result.map(|()| rows)));
            told.expect("the other end is there as long as this thread");
        }
    }

    /// Goes through the cases, computes those that wait and takes over the others.
    fn forwards(
        &self,
        earlier: &[Row],
        waiting: &Waiting,
        finished: &Receiver<Finished>,
        observe: &mut dyn FnMut(Event<'_>),
    ) -> Result<Vec<Row>, Failure> {
        let (mut rows, mut others) = (Vec::new(), BTreeMap::new());
        for (place, &case) in self.cases.iter().enumerate() {
            let result = match take(waiting, VecDeque::pop_front) {
                Some(first) => {
                    debug_assert_eq!(first, place);
                    self.run_case(case, earlier, &mut rows, observe)
                }
                None => {
                    if !self.knows(earlier, case) {
                        observe(Event::Phase(case, Phase::Solve));
                    }
                    take_over(place, finished, &mut others, &mut rows, observe)
                }
            };
            result.map_err(|error| Failure {
                case: Some(case),
                error,
            })?;
            observe(Event::Done(case));
        }
        Ok(rows)
    }
}

/// The rows of a case that the other thread has begun.
fn take_over(
    place: usize,
    finished: &Receiver<Finished>,
    others: &mut BTreeMap<usize, Result<Vec<Row>, Error>>,
    rows: &mut Vec<Row>,
    observe: &mut dyn FnMut(Event<'_>),
) -> Result<(), Error> {
    let of_case = loop {
        match others.remove(&place) {
            Some(of_case) => break of_case?,
            None => others.extend([finished
                .recv()
                .expect("the other thread tells of every case that it takes")]),
        }
    };
    for mut row in of_case {
        row.set_order(rows);
        observe(Event::Row(&row));
        rows.push(row);
    }
    Ok(())
}
