//! What a C header declares, as far as ours goes.

/// A type as it is written, with `*` for every level of pointer, a name, and for arrays in structs their length.
#[derive(Debug)]
pub(crate) struct Variable {
    pub(crate) of_type: String,
    pub(crate) is_const: bool,
    pub(crate) pointers: usize,
    pub(crate) name: String,
    pub(crate) length: Option<usize>,
}

#[derive(Debug)]
pub(crate) struct Function {
    pub(crate) returns: Variable,
    pub(crate) arguments: Vec<Variable>,
}

#[derive(Debug)]
pub(crate) struct Struct {
    pub(crate) name: String,
    pub(crate) fields: Vec<Variable>,
}

#[derive(Debug)]
pub(crate) struct Enum {
    pub(crate) name: String,
    pub(crate) entries: Vec<(String, i64)>,
}

#[derive(Debug, Default)]
pub(crate) struct Declarations {
    /// Entries of enumerations too.
    pub(crate) constants: Vec<(String, i64)>,
    pub(crate) enums: Vec<Enum>,
    /// Structs that are known by pointers alone.
    pub(crate) opaque: Vec<String>,
    pub(crate) structs: Vec<Struct>,
    pub(crate) callbacks: Vec<Function>,
    pub(crate) functions: Vec<Function>,
}

impl Declarations {
    pub(crate) fn of(header: &str) -> Self {
        let mut found = Self::default();
        let mut code = String::new();
        let after_title = header.split_once("*/").expect("a title").1;
        for line in after_title.lines() {
            let line = line.split("//").next().unwrap_or("").trim();
            match line.strip_prefix("#define ").and_then(|rest| rest.split_once(' ')) {
                Some((name, value)) => found.constants.push((name.into(), value.parse().expect("a number"))),
                None if line.starts_with('#') || line.starts_with("extern") => {}
                None => code += &format!("{line} "),
            }
        }
        // The brace that closes `extern "C"` stands alone.
        let mut rest = code.trim().trim_end_matches("*/").trim();
        while let Some(end) = end_of_statement(rest) {
            found.statement(rest[..end].trim());
            rest = rest[end + 1..].trim_start();
        }
        found
    }

    fn statement(&mut self, text: &str) {
        let body = || text.split_once('{').and_then(|(_, rest)| rest.rsplit_once('}'));
        if text.starts_with("typedef enum") {
            let (entries, name) = body().expect("entries");
            let entry = |entry: &str| {
                let (name, value) = entry.split_once('=').expect("a value");
                (name.trim().to_owned(), value.trim().parse().expect("a number"))
            };
            let entries: Vec<_> = entries.split(',').filter(|text| !text.trim().is_empty()).map(entry).collect();
            self.constants.extend(entries.iter().cloned());
            self.enums.push(Enum { name: name.trim().into(), entries });
        } else if text.starts_with("typedef struct {") {
            let (fields, name) = body().expect("fields");
            let fields = fields.split(';').filter(|field| !field.trim().is_empty()).map(Variable::of).collect();
            self.structs.push(Struct { name: name.trim().into(), fields });
        } else if let Some(callback) = text.strip_prefix("typedef ").filter(|rest| rest.contains("(*")) {
            self.callbacks.push(Function::of(&callback.replacen("(*", "", 1).replacen(")(", "(", 1)));
        } else if let Some(opaque) = text.strip_prefix("typedef struct ") {
            self.opaque.push(opaque.split_whitespace().last().expect("a name").into());
        } else {
            self.functions.push(Function::of(text));
        }
    }
}

impl Declarations {
    pub(crate) fn is_callback(&self, of_type: &str) -> bool {
        self.callbacks.iter().any(|callback| callback.returns.name == of_type)
    }

    pub(crate) fn is_opaque(&self, of_type: &str) -> bool {
        self.opaque.iter().any(|name| name == of_type)
    }
}

/// Place of the semicolon that ends a statement: the first outside braces.
fn end_of_statement(text: &str) -> Option<usize> {
    let mut depth = 0;
    text.char_indices().find_map(|(place, letter)| {
        depth += match letter {
            '{' => 1,
            '}' => -1,
            _ => 0,
        };
        (letter == ';' && depth == 0).then_some(place)
    })
}

impl Variable {
    fn of(text: &str) -> Self {
        let (text, length) = match text.trim().split_once('[') {
            Some((text, rest)) => (text.trim(), rest.trim_end_matches(']').parse().ok()),
            None => (text.trim(), None),
        };
        let is_const = text.starts_with("const ");
        let text = text.trim_start_matches("const ");
        let pointers = text.matches('*').count();
        let words: Vec<&str> = text.split(['*', ' ']).filter(|word| !word.is_empty()).collect();
        let [of_type, name] = words[..] else { panic!("'{text}' is no declaration") };
        Self { of_type: of_type.into(), is_const, pointers, name: name.into(), length }
    }
}

impl Function {
    fn of(text: &str) -> Self {
        let (head, arguments) = text.split_once('(').expect("arguments");
        let arguments = arguments.trim_end_matches(')').split(',').map(str::trim).filter(|text| *text != "void");
        Self { returns: Variable::of(head), arguments: arguments.map(Variable::of).collect() }
    }
}
