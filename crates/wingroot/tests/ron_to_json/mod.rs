//! A file in RON as the same file in JSON, by its signs alone: no type is asked.

use serde_json::{Map, Number, Value};

/// Fields in which `None` is a choice of its own, not an absent value.
const CHOICES_WITH_NONE: [&str; 2] = ["root_plane", "actuator"];

/// The JSON form; the name of the outermost type goes.
pub(crate) fn converted(ron: &str) -> Value {
    let mut reader = Reader { tokens: tokens(ron), at: 0 };
    if let [Token::Word(_), Token::Sign('('), ..] = &reader.tokens[..] {
        reader.at = 1;
    }
    let value = reader.value("");
    assert_eq!(reader.at, reader.tokens.len(), "something is left behind the last parenthesis");
    value
}

#[derive(Debug, Clone, PartialEq)]
enum Token {
    Sign(char),
    Text(String),
    Word(String),
}

fn tokens(ron: &str) -> Vec<Token> {
    let mut found = Vec::new();
    let mut rest = ron.trim_start();
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if first == '"' {
            let end = 1 + rest[1..].find('"').expect("an end of the text");
            found.push(Token::Text(rest[1..end].to_owned()));
            end + 1
        } else if "(){}[]:,".contains(first) {
            found.push(Token::Sign(first));
            1
        } else {
            let end = rest.find(|c: char| c.is_whitespace() || "(){}[]:,".contains(c)).unwrap_or(rest.len());
            found.push(Token::Word(rest[..end].to_owned()));
            end
        };
        rest = rest[length..].trim_start();
    }
    found
}

struct Reader {
    tokens: Vec<Token>,
    at: usize,
}

impl Reader {
    fn next(&mut self) -> Token {
        self.at += 1;
        self.tokens[self.at - 1].clone()
    }

    fn is(&self, sign: char) -> bool {
        self.tokens.get(self.at) == Some(&Token::Sign(sign))
    }

    fn value(&mut self, field: &str) -> Value {
        match self.next() {
            Token::Text(text) => text.into(),
            Token::Sign('(') => self.group(')'),
            Token::Sign('{') => self.group('}'),
            Token::Sign('[') => self.list(']').into(),
            Token::Word(word) if self.is('(') => {
                self.at += 1;
                let inner = match self.group(')') {
                    Value::Array(mut one) if one.len() == 1 => one.remove(0),
                    other => other,
                };
                if word == "Some" { inner } else { Map::from_iter([(word, inner)]).into() }
            }
            Token::Word(word) => match word.as_str() {
                "None" if !CHOICES_WITH_NONE.contains(&field) => Value::Null,
                "true" | "false" => (word == "true").into(),
                number if number.starts_with(|c: char| c.is_ascii_digit() || c == '-') => {
                    let whole = number.parse::<i64>().map(Number::from).ok();
                    whole
                        .or_else(|| Number::from_f64(number.parse().expect("a number")))
                        .expect("finite")
                        .into()
                }
                _ => word.into(),
            },
            Token::Sign(sign) => panic!("{sign} where a value should be"),
        }
    }

    /// Fields or entries if the second sign is a colon, else a tuple.
    fn group(&mut self, end: char) -> Value {
        if self.tokens.get(self.at + 1) != Some(&Token::Sign(':')) {
            return self.list(end).into();
        }
        let mut fields = Map::new();
        while !self.is(end) {
            let (Token::Word(name) | Token::Text(name)) = self.next() else {
                panic!("a name should be here")
            };
            assert_eq!(self.next(), Token::Sign(':'));
            let value = self.value(&name);
            fields.insert(name, value);
            self.at += usize::from(self.is(','));
        }
        self.at += 1;
        fields.into()
    }

    fn list(&mut self, end: char) -> Vec<Value> {
        let mut values = Vec::new();
        while !self.is(end) {
            values.push(self.value(""));
            self.at += usize::from(self.is(','));
        }
        self.at += 1;
        values
    }
}
