//! Why an edit was not made.

use super::Message;
use vitrine::scene::{Cause, ParamError, ParamKind, Range};

/// Why an edit was not made. Then nothing has changed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EditError {
    /// A value does not fit its parameter.
    #[error("{error}")]
    Param {
        /// What is wrong with it.
        error: ParamError,
        /// What the parameter takes; None when there is no such parameter.
        kind: Option<ParamKind>,
    },
    /// There is no such thing.
    #[error("there is no such thing in the scene")]
    NoThing,
    /// None of the things can be changed in this way: the camera deleted, a material moved.
    #[error("nothing of what was chosen can be changed in this way")]
    NotPossible,
    /// There is no such kind.
    #[error("there is no kind `{word}`")]
    NoKind {
        /// As given.
        word: String,
    },
    /// A name is empty.
    #[error("the name is empty")]
    EmptyName,
    /// A name belongs to another thing.
    #[error("the name `{name}` is taken")]
    NameTaken {
        /// As given.
        name: String,
    },
    /// Numbers that mean nothing: not finite, or zero times as large.
    #[error("these numbers mean nothing here")]
    BadNumbers,
    /// The scene would mean nothing afterwards.
    #[error("{0}")]
    Scene(Cause),
    /// A model or picture cannot be read.
    #[error("{reason}")]
    File {
        /// What is wrong, with the path.
        reason: String,
        /// How to mend it.
        help: String,
    },
    /// What is pasted is no scene.
    #[error("line {line}: {reason}")]
    NotAScene {
        /// The line, counted from 1.
        line: usize,
        /// What is wrong there.
        reason: String,
        /// How to mend it.
        help: String,
    },
    /// There is nothing to paste or to add.
    #[error("there is nothing to add")]
    NothingToAdd,
    /// A group that is larger along one axis than along another, or turned beneath, holds a turned member: alone, the member
    /// would need edges that are not at right angles.
    #[error("`{name}` is stretched askew by its group and cannot keep its form without it")]
    Askew {
        /// The member.
        name: String,
    },
}

impl EditError {
    /// What is wrong, for a person.
    #[must_use]
    pub fn message(&self) -> Message {
        match self {
            Self::Param { kind: Some(kind), .. } => allowed(*kind),
            Self::Param { error, .. } => Message::new("edit-no-parameter").with("reason", error),
            Self::NoThing => Message::new("edit-no-thing"),
            Self::NotPossible => Message::new("edit-not-possible"),
            Self::NoKind { word } => Message::new("edit-no-kind").with("word", word),
            Self::EmptyName => Message::new("edit-name-empty"),
            Self::NameTaken { name } => Message::new("edit-name-taken").with("name", name),
            Self::BadNumbers => Message::new("edit-bad-numbers"),
            Self::Scene(cause) => problem(cause),
            Self::File { reason, help } => {
                Message::new("edit-file").with("reason", reason).with("help", help)
            }
            Self::NotAScene { line, reason, help } => {
                Message::new("edit-not-a-scene").with("line", line).with("reason", reason).with("help", help)
            }
            Self::NothingToAdd => Message::new("edit-nothing-to-add"),
            Self::Askew { name } => Message::new("edit-askew").with("name", name),
        }
    }
}

/// What a parameter takes, for a person: "A number from 0 to 1".
#[must_use]
pub fn allowed(kind: ParamKind) -> Message {
    match kind {
        ParamKind::Flag => Message::new("allowed-flag"),
        ParamKind::Integer { min, max } => {
            Message::new("allowed-integer").with("min", &min).with("max", &max)
        }
        ParamKind::Size { min, max } => Message::new("allowed-size").with("min", &min).with("max", &max),
        ParamKind::Number(range) | ParamKind::Pair(range) | ParamKind::Vector(range) => numbers(range),
        ParamKind::Direction => Message::new("allowed-direction"),
        ParamKind::Scale => Message::new("allowed-scale"),
        ParamKind::Color => Message::new("allowed-color"),
        ParamKind::Points(_) | ParamKind::Pairs(_) => Message::new("allowed-finite"),
        ParamKind::Choice(words) => Message::new("allowed-choice").with("words", &words.join(", ")),
        ParamKind::Text => Message::new("allowed-text"),
        ParamKind::Reference(_) => Message::new("allowed-reference"),
        ParamKind::File => Message::new("allowed-file"),
    }
}

fn numbers(range: Range) -> Message {
    let (from, to) = (range.min > f32::MIN, range.max < f32::MAX);
    let key = match (from, to, range.above_min) {
        (false, false, _) => "allowed-finite",
        (true, false, true) => "allowed-more-than",
        (true, false, false) => "allowed-at-least",
        (false, true, _) => "allowed-at-most",
        (true, true, true) => "allowed-more-than-to",
        (true, true, false) => "allowed-from-to",
    };
    let ends = [("min", range.min, from), ("max", range.max, to)];
    ends.into_iter().filter(|(.., is_told)| *is_told).fold(Message::new(key), |m, (n, v, _)| m.with(n, &v))
}

/// What is wrong with a scene as a whole, for a person.
#[must_use]
pub fn problem(cause: &Cause) -> Message {
    match cause {
        Cause::DuplicateName { name, .. } => Message::new("problem-duplicate-name").with("name", name),
        Cause::EmptyName => Message::new("edit-name-empty"),
        Cause::MissingReference { name, .. } => Message::new("problem-missing-reference").with("name", name),
        Cause::GroupCycle { name } => Message::new("problem-group-cycle").with("name", name),
        Cause::Fault(fault) => match fault.key {
            "points" => Message::new("problem-flat-triangle"),
            "look_at" => Message::new("problem-look-at"),
            _ => Message::new("problem-fault").with("reason", fault.message),
        },
        Cause::PictureTooLarge { width, height } => {
            Message::new("problem-picture-too-large").with("width", width).with("height", height)
        }
        Cause::NoLight => Message::new("problem-no-light"),
        Cause::NoObject => Message::new("problem-no-object"),
        Cause::OpenSolid { name } => Message::new("problem-open-model").with("name", name),
        Cause::EqualSolids { name, other } => {
            Message::new("problem-equal-solids").with("name", name).with("other", other)
        }
        Cause::CameraInside { name } => Message::new("problem-camera-inside").with("name", name),
    }
}
