//! Reads printed formulas back, at a point: enough of each notation to evaluate what `symbol` writes.

use std::collections::HashMap;

use grazing::symbol::Format;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero, pow};

type Point<'a> = HashMap<&'a str, BigRational>;

/// The value of a polynomial expression: sums, products with or without a sign between, powers as ^ or **,
/// braces as in LaTeX.
pub fn infix(text: &str, at: &Point) -> BigRational {
    let text = text.replace("**", "^").replace(['_', '{', '}', '\\', '&'], "");
    let mut rest: &str = text.trim();
    let value = sum(&mut rest, at);
    assert!(rest.is_empty(), "{rest:?} is left of {text:?}");
    value
}

fn take(rest: &mut &str, c: char) -> bool {
    let found = rest.strip_prefix(c).map(str::trim_start);
    *rest = found.unwrap_or(rest);
    found.is_some()
}

fn word<'a>(rest: &mut &'a str) -> &'a str {
    let end = rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len());
    let (word, tail) = rest.split_at(end);
    *rest = tail.trim_start();
    word
}

fn sum(rest: &mut &str, at: &Point) -> BigRational {
    let mut total = if take(rest, '-') { -term(rest, at) } else { term(rest, at) };
    loop {
        match (take(rest, '+'), take(rest, '-')) {
            (true, _) => total += term(rest, at),
            (_, true) => total -= term(rest, at),
            _ => return total,
        }
    }
}

fn term(rest: &mut &str, at: &Point) -> BigRational {
    let mut product = factor(rest, at);
    while take(rest, '*') || rest.starts_with(|c: char| c == '(' || c.is_alphanumeric()) {
        product *= factor(rest, at);
    }
    product
}

fn factor(rest: &mut &str, at: &Point) -> BigRational {
    let base = if take(rest, '(') {
        let value = sum(rest, at);
        assert!(take(rest, ')'), "a parenthesis is open before {rest:?}");
        value
    } else {
        let name = word(rest);
        at.get(name).cloned().unwrap_or_else(|| BigRational::from(name.parse::<BigInt>().expect(name)))
    };
    if take(rest, '^') { pow(base, word(rest).parse().expect("an exponent")) } else { base }
}

/// The mathematics of a LaTeX text, each line of it without the dollars around it and what is for breaking.
pub fn maths(text: &str) -> String {
    let inner = |line: &str| line.split('$').nth(1).map(|maths| maths.replace("\\allowbreak ", ""));
    text.lines().filter_map(inner).map(|line| line + "\n").collect()
}

/// The left sides of all comparisons with 0, in order, with their relations.
pub fn comparisons(text: &str, format: Format, at: &Point) -> Vec<(String, BigRational)> {
    let body = match format {
        Format::Text => text.split_once(":\n").expect("a colon ends the quantifiers").1,
        Format::Latex => text.split_once(":\n").expect("a colon ends the quantifiers").1,
        Format::Sympy => text.split_once("sentence = ").expect("an assignment").1,
        _ => text.split_once("(A ").and_then(|(_, t)| t.split_once(") [")).expect("quantifiers").1,
    };
    let mut body = body.replace("\\ge", ">=");
    for word in
        ["implies", "iff", "and", "\\land", "/\\", "<==>", "==>", "Implies(", "Equivalent(", "And(", ","]
    {
        body = body.replace(word, "\n");
    }
    let mut found = Vec::new();
    for line in body.lines() {
        let Some((left, relation)) = [" >= 0", " > 0", " < 0"].into_iter().find_map(|relation| {
            Some((line.split_once(relation)?.0, relation.trim_end_matches(" 0").trim()))
        }) else {
            continue;
        };
        let left = left.trim_start_matches(|c: char| "([ ".contains(c));
        found.push((relation.to_string(), infix(left, at)));
    }
    found
}

/// SMT-LIB 2.
pub mod prefix {
    use super::*;

    #[derive(Debug)]
    enum Tree {
        Leaf(String),
        Node(Vec<Tree>),
    }

    #[derive(Debug, Clone, PartialEq)]
    enum Value {
        Number(BigRational),
        Truth(bool),
    }

    fn trees(script: &str) -> Vec<Tree> {
        let lines = script.lines().filter(|line| !line.starts_with(';'));
        let text = lines.collect::<Vec<_>>().join(" ").replace('(', " ( ").replace(')', " ) ");
        let mut open = vec![Vec::new()];
        for token in text.split_whitespace() {
            match token {
                "(" => open.push(Vec::new()),
                ")" => {
                    let node = Tree::Node(open.pop().expect("balanced"));
                    open.last_mut().expect("balanced").push(node);
                }
                leaf => open.last_mut().expect("balanced").push(Tree::Leaf(leaf.into())),
            }
        }
        assert_eq!(open.len(), 1, "balanced");
        open.remove(0)
    }

    /// One pass over a script at a point: what it defines, asserts and compares.
    struct Run<'a> {
        names: HashMap<String, BigRational>,
        defined: Vec<BigRational>,
        asserted: Vec<bool>,
        compared: Vec<(String, BigRational)>,
        at: &'a Point<'a>,
    }

    impl Run<'_> {
        fn new<'a>(script: &str, at: &'a Point<'a>) -> Run<'a> {
            let mut run =
                Run { names: HashMap::new(), defined: vec![], asserted: vec![], compared: vec![], at };
            let mut asked = false;
            for tree in trees(script) {
                let Tree::Node(parts) = tree else { panic!("a command is a list") };
                let words: Vec<_> =
                    parts.iter().map(|p| if let Tree::Leaf(word) = p { word.as_str() } else { "" }).collect();
                match words[..] {
                    ["set-logic", "QF_NRA"] => {}
                    ["declare-const", name, "Real"] => assert!(at.contains_key(name)),
                    ["define-fun", name, _, "Real", _] => {
                        let Value::Number(value) = run.value(&parts[4]) else { panic!("not a number") };
                        run.defined.push(value.clone());
                        run.names.insert(name.into(), value);
                    }
                    ["assert", _] => {
                        let Value::Truth(truth) = run.value(&parts[1]) else { panic!("not a formula") };
                        run.asserted.push(truth);
                    }
                    ["check-sat"] => asked = true,
                    _ => panic!("{words:?}"),
                }
            }
            assert!(asked);
            run
        }

        fn value(&mut self, tree: &Tree) -> Value {
            let parts = match tree {
                Tree::Leaf(name) => {
                    let known = self.at.get(name.as_str()).or(self.names.get(name)).cloned();
                    return Value::Number(
                        known.unwrap_or_else(|| BigRational::from(name.parse::<BigInt>().expect(name))),
                    );
                }
                Tree::Node(parts) => parts,
            };
            let Tree::Leaf(operator) = &parts[0] else { panic!("an operator is a word") };
            let values: Vec<_> = parts[1..].iter().map(|part| self.value(part)).collect();
            let numbers =
                || values.iter().map(|v| if let Value::Number(x) = v { x.clone() } else { panic!("{v:?}") });
            let compared = |holds: bool| {
                let left = numbers().next().expect("two operands");
                assert_eq!(numbers().nth(1), Some(BigRational::zero()));
                (Value::Truth(holds), (operator.clone(), left))
            };
            let first = || numbers().next().expect("an operand");
            let (value, comparison) = match operator.as_str() {
                "+" => return Value::Number(numbers().sum()),
                "*" => return Value::Number(numbers().fold(BigRational::one(), |x, y| x * y)),
                "-" if values.len() == 1 => return Value::Number(-first()),
                "and" => return Value::Truth(values.iter().all(|v| *v == Value::Truth(true))),
                "not" => return Value::Truth(values[0] == Value::Truth(false)),
                "=" => return Value::Truth(values[0] == values[1]),
                ">" => compared(first() > BigRational::zero()),
                "<" => compared(first() < BigRational::zero()),
                ">=" => compared(first() >= BigRational::zero()),
                _ => panic!("{operator}"),
            };
            self.compared.push(comparison);
            value
        }
    }

    /// The values of what the script defines.
    pub fn definitions(script: &str, at: &Point) -> Vec<BigRational> {
        Run::new(script, at).defined
    }

    /// Whether each assertion holds at the point.
    pub fn asserted(script: &str, at: &Point) -> Vec<bool> {
        Run::new(script, at).asserted
    }

    /// The left sides of all comparisons with 0, in order, with their relations.
    pub fn comparisons(script: &str, at: &Point) -> Vec<(String, BigRational)> {
        Run::new(script, at).compared
    }
}
