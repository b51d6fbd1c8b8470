//! One parameter of a command, which is also one cell of an object.

use crate::Dimension;

/// How object names in a field are to be understood.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Names {
    /// The object must exist.
    Old,
    /// The object must not exist; it is created.
    New,
    /// Either; it is created if missing.
    OldOrNew,
}

/// The type of a field's value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Name of the object the command is about or refers to; the string is a class id or a family
    /// (`"marker"`, `"part"`, `"body"`, `"force"`, `"frame"`, `"any"`).
    Object(Names, &'static str),
    Integer,
    Real,
    /// One of two words; the first means true (`yes`/`no`, `on`/`off`, `true`/`false`).
    Boolean(&'static str, &'static str),
    /// One of several words, abbreviated to a unique prefix; stored as the full word.
    Choice(&'static [&'static str]),
    Text,
    /// Run-time function text, possibly given as several strings that are joined.
    Function,
    /// Three coordinates in the current coordinate system, converted to the frame of the owner.
    Location,
    /// Three angles in the current sequence, stored as body 3-1-3 in the frame of the owner.
    Orientation,
    /// Path of a file.
    File,
    /// Any value or expression: variables, conditions.
    Any,
}

/// How many values a field takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    pub least: usize,
    pub most: usize,
}

impl Count {
    pub const ONE: Count = Count { least: 1, most: 1 };
    pub const MANY: Count = Count { least: 1, most: usize::MAX };
    pub const fn exactly(n: usize) -> Count {
        Count { least: n, most: n }
    }
    pub const fn between(least: usize, most: usize) -> Count {
        Count { least, most }
    }
}

/// What holds when the field is not given on `create`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Default {
    /// Stays unset.
    None,
    /// A number in the current units.
    Number(f64),
    /// A word or text.
    Word(&'static str),
    /// The current default object of the field's class; a name given becomes the default.
    Current,
    /// The default coordinate system.
    CoordinateSystem,
    /// Generated: prefix and number.
    Generated,
    /// An expression over other cells of the object, which is kept: `@.width * @.height`, where `@`
    /// stands for the object. Fields it reads come before it.
    Formula(&'static str),
}

/// Bounds of a number. A number outside is stored with a warning when it is typed, and refused where
/// it is used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    None,
    Above(f64),
    AtLeast(f64),
    /// Exactly zero, or not below a number.
    ZeroOrAtLeast(f64),
}

impl Limit {
    /// Whether a number is within the bounds.
    #[must_use]
    pub fn allows(self, x: f64) -> bool {
        match self {
            Limit::None => true,
            Limit::Above(least) => x > least,
            Limit::AtLeast(least) => x >= least,
            Limit::ZeroOrAtLeast(least) => x == 0.0 || x >= least,
        }
    }
}

impl std::fmt::Display for Limit {
    /// What a number must be, to go behind "it must be".
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Limit::None => f.write_str("a number"),
            Limit::Above(least) => write!(f, "greater than {least}"),
            Limit::AtLeast(least) => write!(f, "at least {least}"),
            Limit::ZeroOrAtLeast(least) => write!(f, "0 or at least {least}"),
        }
    }
}

/// In which of the two commands of a group the field is a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    Both,
    Create,
    Modify,
}

/// One parameter of a command. Build with the constructors and the chained setters, all `const`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Field {
    pub name: &'static str,
    pub kind: Kind,
    pub dimension: Dimension,
    /// Field of the same object whose word names the kind of quantity (`length`), where each object
    /// has its own; the dimension here holds for objects that say none.
    pub quantity_in: Option<&'static str>,
    pub count: Count,
    /// Side of a symmetric matrix whose lower triangle by columns the values are; all terms of the
    /// matrix are taken too.
    pub symmetric: Option<usize>,
    pub default: Default,
    pub limit: Limit,
    pub required: bool,
    pub usage: Use,
    /// Name of the argument of the solver statement, where there is one (`EMODULUS`).
    pub keyword: Option<&'static str>,
    /// One sentence of our own, lower case, no full stop.
    pub doc: &'static str,
}

impl Field {
    pub const fn new(name: &'static str, kind: Kind) -> Field {
        Field {
            name,
            kind,
            dimension: Dimension::NONE,
            quantity_in: None,
            count: Count::ONE,
            symmetric: None,
            default: Default::None,
            limit: Limit::None,
            required: false,
            usage: Use::Both,
            keyword: None,
            doc: "",
        }
    }

    /// Reference to an existing object of a class or family.
    pub const fn object(name: &'static str, class: &'static str) -> Field {
        Field::new(name, Kind::Object(Names::Old, class))
    }

    /// References to existing objects; wildcards are allowed.
    pub const fn objects(name: &'static str, class: &'static str) -> Field {
        Field::object(name, class).many()
    }

    pub const fn real(name: &'static str, dimension: Dimension) -> Field {
        let mut field = Field::new(name, Kind::Real);
        field.dimension = dimension;
        field
    }

    pub const fn reals(name: &'static str, count: usize) -> Field {
        Field::new(name, Kind::Real).count(Count::exactly(count))
    }

    pub const fn integer(name: &'static str) -> Field {
        Field::new(name, Kind::Integer)
    }

    pub const fn text(name: &'static str) -> Field {
        Field::new(name, Kind::Text)
    }

    pub const fn texts(name: &'static str) -> Field {
        Field::new(name, Kind::Text).many()
    }

    pub const fn function(name: &'static str) -> Field {
        Field::new(name, Kind::Function)
    }

    pub const fn choice(name: &'static str, words: &'static [&'static str]) -> Field {
        Field::new(name, Kind::Choice(words))
    }

    pub const fn yes_no(name: &'static str) -> Field {
        Field::new(name, Kind::Boolean("yes", "no"))
    }

    pub const fn on_off(name: &'static str) -> Field {
        Field::new(name, Kind::Boolean("on", "off"))
    }

    pub const fn true_false(name: &'static str) -> Field {
        Field::new(name, Kind::Boolean("true", "false"))
    }

    /// The lower triangle by columns of a symmetric matrix of that many rows.
    pub const fn lower_triangle(mut self, side: usize) -> Field {
        self.symmetric = Some(side);
        self.count(Count::exactly(side * (side + 1) / 2))
    }

    /// Three coordinates.
    pub const fn location(name: &'static str) -> Field {
        let mut field = Field::new(name, Kind::Location).count(Count::exactly(3));
        field.dimension = Dimension::LENGTH;
        field
    }

    /// Three angles.
    pub const fn orientation(name: &'static str) -> Field {
        let mut field = Field::new(name, Kind::Orientation).count(Count::exactly(3));
        field.dimension = Dimension::ANGLE;
        field
    }

    pub const fn many(self) -> Field {
        self.count(Count::MANY)
    }

    pub const fn count(mut self, count: Count) -> Field {
        self.count = count;
        self
    }

    pub const fn dimension(mut self, dimension: Dimension) -> Field {
        self.dimension = dimension;
        self
    }

    /// The quantity is what another field of the object says.
    pub const fn quantity_in(mut self, field: &'static str) -> Field {
        self.quantity_in = Some(field);
        self
    }

    pub const fn default(mut self, value: f64) -> Field {
        self.default = Default::Number(value);
        self
    }

    pub const fn default_word(mut self, word: &'static str) -> Field {
        self.default = Default::Word(word);
        self
    }

    /// The current default object stands in; a name given becomes the default.
    pub const fn current(mut self) -> Field {
        self.default = Default::Current;
        self
    }

    /// Follows from other cells of the object until a value is given, see [`Default::Formula`].
    pub const fn formula(mut self, expression: &'static str) -> Field {
        self.default = Default::Formula(expression);
        self
    }

    pub const fn or_default_coordinate_system(mut self) -> Field {
        self.default = Default::CoordinateSystem;
        self
    }

    pub const fn above(mut self, limit: f64) -> Field {
        self.limit = Limit::Above(limit);
        self
    }

    pub const fn at_least(mut self, limit: f64) -> Field {
        self.limit = Limit::AtLeast(limit);
        self
    }

    /// Zero says that the effect is absent; other numbers are at least the limit.
    pub const fn zero_or_at_least(mut self, limit: f64) -> Field {
        self.limit = Limit::ZeroOrAtLeast(limit);
        self
    }

    pub const fn required(mut self) -> Field {
        self.required = true;
        self
    }

    /// A parameter of the create command only.
    pub const fn on_create(mut self) -> Field {
        self.usage = Use::Create;
        self
    }

    /// A parameter of the modify command only.
    pub const fn on_modify(mut self) -> Field {
        self.usage = Use::Modify;
        self
    }

    pub const fn keyword(mut self, keyword: &'static str) -> Field {
        self.keyword = Some(keyword);
        self
    }

    pub const fn doc(mut self, doc: &'static str) -> Field {
        self.doc = doc;
        self
    }
}
