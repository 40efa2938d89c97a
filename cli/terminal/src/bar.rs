//! A bar of progress on standard error.

use std::io::{IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// How many characters the bar itself takes.
const WIDTH: u64 = 30;

/// How often it is drawn: the time that has passed is to move on while nothing else does.
const TICK: Duration = Duration::from_millis(200);

/// A bar that is drawn where standard error is a terminal, and nowhere else; it goes away when it is dropped.
pub struct Bar {
    state: Arc<Mutex<State>>,
    /// What draws, until its sender is dropped.
    drawing: Option<(Sender<()>, JoinHandle<()>)>,
}

/// What there is to be drawn.
struct State {
    start: Instant,
    position: u64,
    length: u64,
    message: String,
}

impl Bar {
    /// An empty bar of this length, in whatever unit.
    pub fn new(length: u64) -> Self {
        Self::drawn(length, can_draw())
    }

    /// One that nobody sees.
    pub fn hidden(length: u64) -> Self {
        Self::drawn(length, false)
    }

    fn drawn(length: u64, drawn: bool) -> Self {
        let state = Arc::new(Mutex::new(State {
            start: Instant::now(),
            position: 0,
            length,
            message: String::new(),
        }));
        let drawing = drawn.then(|| {
            let (stop, stopped) = channel();
            let shared = Arc::clone(&state);
            let draw = move || {
                while stopped.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                    locked(&shared).draw();
                }
            };
            (stop, std::thread::spawn(draw))
        });
        Self { state, drawing }
    }

    /// Moves to a place and says what goes on there.
    pub fn place(&self, position: u64, message: impl Into<String>) {
        let mut state = locked(&self.state);
        (state.position, state.message) = (position, message.into());
    }

    /// Moves on by one, of this many, and says what goes on there.
    pub fn advance(&self, length: u64, message: impl Into<String>) {
        let mut state = locked(&self.state);
        state.length = length;
        (state.position, state.message) = (state.position + 1, message.into());
    }

    /// Is there anybody who sees it?
    pub fn is_drawn(&self) -> bool {
        self.drawing.is_some()
    }

    /// Prints with the bar out of the way.
    pub fn aside<T>(&self, print: impl FnOnce() -> T) -> T {
        let _not_drawn = locked(&self.state);
        if self.is_drawn() {
            clear();
        }
        print()
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some((stop, thread)) = self.drawing.take() {
            drop(stop);
            // Where drawing has panicked there is nothing to wait for.
            let _ = thread.join();
            clear();
        }
    }
}

/// Is standard error a terminal that can go back to the beginning of a line? A bar has no colours: `NO_COLOR` is for others.
fn can_draw() -> bool {
    let dumb = std::env::var_os("TERM").is_some_and(|kind| kind == "dumb");
    std::io::stderr().is_terminal() && !dumb
}

/// Numbers and words are right even where a thread has panicked that held them.
pub(super) fn locked<T>(state: &Mutex<T>) -> MutexGuard<'_, T> {
    state.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A terminal that takes no characters has no use for a bar: what fails is not said.
fn put(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

fn clear() {
    put("\r\x1b[K");
}

impl State {
    /// With line wrapping off for the moment: a line that is too long is cut by the terminal, and can be overwritten.
    fn draw(&self) {
        put(&format!("\r\x1b[?7l{}\x1b[K\x1b[?7h", self.line()));
    }

    /// `00:01:05 [=====>     ]  42% what goes on`.
    fn line(&self) -> String {
        let part = |of: u64| (self.position.min(self.length) * of) / self.length.max(1);
        let seconds = self.start.elapsed().as_secs();
        let full = part(WIDTH) as usize;
        format!(
            "{:02}:{:02}:{:02} [{:WIDTH$}] {:>3}% {}",
            seconds / 3600,
            seconds / 60 % 60,
            seconds % 60,
            "=".repeat(full) + if part(100) < 100 { ">" } else { "" },
            part(100),
            self.message,
            WIDTH = WIDTH as usize
        )
    }
}

/// What is said of the time that is left when this share of some work took so long: nothing before there is anything to judge by.
pub fn left(share: f64, elapsed: Duration) -> String {
    match share >= 1e-3 {
        false => String::new(),
        true => {
            let rest = elapsed.mul_f64((1.0 / share - 1.0).max(0.0));
            format!("; about {} left", in_words(rest))
        }
    }
}

/// A time in the largest unit that it has more than one of: `90 s`, `12 min`, `30 h`.
fn in_words(time: Duration) -> String {
    match time.as_secs() {
        seconds @ 0..120 => format!("{seconds} s"),
        seconds @ 120..7200 => format!("{} min", seconds / 60),
        seconds => format!("{} h", seconds / 3600),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left() {
        let after = |share| left(share, Duration::from_secs(30));
        assert_eq!(after(0.25), "; about 90 s left");
        assert_eq!(after(1.0), "; about 0 s left");
        assert_eq!(after(0.01), "; about 49 min left");
        for nothing in [0.0, 1e-300, -0.5, f64::NAN] {
            assert_eq!(after(nothing), "");
        }
        assert_eq!(after(1.5), "; about 0 s left");
    }

    fn line(position: u64, length: u64) -> String {
        let state = State {
            start: Instant::now(),
            position,
            length,
            message: "solution".into(),
        };
        state.line()
    }

    #[test]
    fn a_line_has_the_same_width_at_every_place() {
        let empty = ">".to_owned() + &" ".repeat(29);
        assert_eq!(line(0, 8), format!("00:00:00 [{empty}]   0% solution"));
        let half = "=".repeat(15) + ">" + &" ".repeat(14);
        assert_eq!(line(4, 8), format!("00:00:00 [{half}]  50% solution"));
        let full = "=".repeat(30);
        for (position, length) in [(8, 8), (9, 8)] {
            assert_eq!(
                line(position, length),
                format!("00:00:00 [{full}] 100% solution")
            );
        }
        assert_eq!(line(0, 0), line(0, 8), "nothing is known yet");
    }

    #[test]
    fn times_in_words() {
        let words = |seconds| in_words(Duration::from_secs(seconds));
        assert_eq!([1, 119, 120].map(words), ["1 s", "119 s", "2 min"]);
        assert_eq!([7199, 7200].map(words), ["119 min", "2 h"]);
    }
}
