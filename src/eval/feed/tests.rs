use super::{Cursor, Feed, Role};
use crate::diag::{FileId, SourceMap, Span};
use crate::syntax::{Directive, Position, Source, Text, TokenKind, Words};
use std::rc::Rc;
use std::sync::Arc;

fn source(file: u32, text: &str) -> Rc<Source> {
    Rc::new(Source::new(FileId(file), Arc::new(Text::new(text.as_bytes().to_vec()))))
}

/// Over a scene file.
fn scene(text: &str) -> Feed {
    let mut feed = Feed::default();
    feed.push(Cursor::new(source(0, text), (Position::default(), None), Role::Main));
    feed
}

/// The tokens of the innermost cursor, as a message would call the first of each.
fn kinds(feed: &mut Feed, words: &mut Words) -> Vec<TokenKind> {
    std::iter::from_fn(|| feed.fetch(words)).map(|token| token.kind).collect()
}

#[test]
fn tokens_come_in_order_until_the_cursor_is_left() {
    let (mut feed, mut words) = (scene("1 < A ;"), Words::default());
    let name = words.intern("A");
    let expected = [TokenKind::Number(1.0), TokenKind::Punct('<'), TokenKind::Name(name), TokenKind::Punct(';')];
    assert_eq!(kinds(&mut feed, &mut words), expected);
    assert!(feed.pop().is_some());
    assert_eq!(feed.fetch(&mut words).map(|t| t.kind), Some(TokenKind::End), "without a cursor there is only the end");
}

#[test]
fn one_token_is_held_back() {
    let (mut feed, mut words) = (scene("1 A"), Words::default());
    assert!(feed.hold_plain().is_none(), "nothing is loaded before the first token is fetched");
    let first = feed.fetch(&mut words).unwrap();
    feed.hold(first, false);
    assert_eq!((feed.ready(), feed.held().copied()), (None, Some(first)));
    assert_eq!((feed.next_index(), feed.position().index), (0, 1));
    feed.hold(first, true);
    assert_eq!(feed.ready(), Some(TokenKind::Number(1.0)));
    let held = feed.set_aside();
    assert!(feed.held().is_none() && feed.hold_plain().is_none(), "a name may be a macro");
    feed.bring_back(held);
    assert_eq!((feed.release(), feed.release()), (Some(first), None));
}

#[test]
fn a_loop_is_a_jump_back() {
    let (mut feed, mut words) = (scene("1 2 3"), Words::default());
    assert_eq!(kinds(&mut feed, &mut words).len(), 3);
    let second = feed.position_of(1);
    feed.jump(second, &mut words);
    assert_eq!(kinds(&mut feed, &mut words), [TokenKind::Number(2.0), TokenKind::Number(3.0)]);
    feed.go_on_at(2);
    assert_eq!(kinds(&mut feed, &mut words), [TokenKind::Number(3.0)]);
}

#[test]
fn branches_are_skipped_to_where_they_end() {
    let (mut feed, mut words) = (scene("#if (1) 2 #while (3) #end #else 4 #end 5"), Words::default());
    assert_eq!(feed.fetch(&mut words).map(|t| t.kind), Some(TokenKind::Directive(Directive::If)));
    assert_eq!(feed.skip_branch(&mut words), Some(Directive::Else));
    assert_eq!(feed.skip_branch(&mut words), Some(Directive::End));
    assert!(feed.skip_branch(&mut words).is_none() && feed.bad_in_branch(&mut words).is_none());
    assert_eq!(kinds(&mut feed, &mut words), [TokenKind::Number(5.0)]);
}

#[test]
fn includes_and_macros_stand_on_top_and_are_told_of() {
    let (mut feed, mut words) = (scene("1"), Words::default());
    let name = words.intern("Tree");
    let call = |start| Span { file: FileId(0), start, end: start + 1 };
    let mut push = |file, role, start| {
        let mut cursor = Cursor::new(source(file, "7 8"), (Position::default(), None), role);
        cursor.call = call(start);
        feed.push(cursor);
    };
    push(1, Role::Include, 3);
    push(1, Role::Macro(name), 5);
    push(1, Role::Macro(name), 5);
    let trail = feed.trail(&words);
    let told: Vec<_> = trail.iter().map(|(span, what)| (span.start, what.as_str())).collect();
    assert_eq!(told, [(5, "in macro 'Tree', called"), (3, "in a file included")]);
    assert_eq!((feed.depth(), feed.below_macro(), feed.in_include()), (4, Some((3, 0)), true));
    feed.fence(&mut words);
    let end = std::iter::from_fn(|| feed.fetch(&mut words)).nth(2);
    assert_eq!(end.map(|t| t.kind), Some(TokenKind::End), "a fenced cursor reports its end");
    assert_eq!((feed.leave_all(), feed.depth(), feed.in_include()), (2, 1, false));
    assert_eq!(kinds(&mut feed, &mut words), [TokenKind::Number(1.0)]);
}

#[test]
fn literal_vectors_are_read_in_a_row() {
    let (mut feed, mut words) = (scene("<1,2>, <3,4>, <5,6>;"), Words::default());
    let first = feed.fetch(&mut words).unwrap();
    feed.hold(first, true);
    let mut read = Vec::new();
    feed.take_vectors(2, |v, n| read.push((v[0], v[1], n)));
    assert_eq!(read, [(1.0, 2.0, 2), (3.0, 4.0, 2)]);
    assert!(matches!(
        kinds(&mut feed, &mut words)[..],
        [TokenKind::Punct(','), TokenKind::Vector, TokenKind::Punct(';')]
    ));
    assert_eq!(feed.literal().0[..2], [5.0, 6.0]);
}

#[test]
fn files_are_looked_for_beside_those_being_read() {
    let (mut sources, text) = (SourceMap::default(), Arc::new(Vec::new()));
    for name in ["scenes/a.pov", "lib/b.inc", "scenes/c.inc"] {
        sources.add(name, Arc::clone(&text));
    }
    let mut feed = scene("");
    for file in [1, 2] {
        feed.push(Cursor::new(source(file, ""), (Position::default(), None), Role::Include));
    }
    assert_eq!(feed.folders(&sources), ["scenes", "lib"].map(std::path::PathBuf::from));
}
