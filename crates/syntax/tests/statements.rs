//! One test per rule of lines, words, lists and values.

mod common;
use common::{clean, codes, shape};

use flexure_syntax::command::{Parser, comments};
use text::FileId;

#[test]
fn keywords_come_before_the_first_pair() {
    assert_eq!(
        shape("force create element_like beam  ixx=4 iyy = 2"),
        "force create element_like beam | ixx = 4.0 | iyy = 2.0"
    );
    assert_eq!(shape("model verify"), "model verify");
    assert_eq!(shape("?"), "?");
}

#[test]
fn a_mark_continues_with_or_without_a_blank_before_it() {
    assert_eq!(shape("a b = 0.4&\nc = 1 &  \t\r\nd=2"), "a | b = 0.4 | c = 1.0 | d = 2.0");
}

#[test]
fn a_comment_may_follow_a_mark_and_stand_between_continued_lines() {
    assert_eq!(shape("a b=1 & ! why = 3 &\n  ! c = 2 &\n ! d = 2\n e=3"), "a | b = 1.0 | e = 3.0");
}

#[test]
fn a_mark_inside_a_comment_continues_nothing() {
    assert_eq!(shape("a b=1 ! c &\nd e=2"), "a | b = 1.0 ; d | e = 2.0");
    assert_eq!(shape("a b=1 & ! c &\ne=2"), "a | b = 1.0 | e = 2.0");
}

#[test]
fn a_mark_in_a_comment_outside_a_command_continues_nothing() {
    assert_eq!(shape("! one &\n! two &\nmodel create"), "model create");
}

#[test]
fn an_empty_line_ends_a_continued_command_and_a_lone_mark_does_not() {
    assert_eq!(shape("a b=1 &\n  \nc d=2"), "a | b = 1.0 ; c | d = 2.0");
    assert_eq!(shape("a b=1 &\n &\nc=2"), "a | b = 1.0 | c = 2.0");
    assert_eq!(shape("a b=1 &\n ! note\n\nc d=2"), "a | b = 1.0 ; c | d = 2.0");
    assert_eq!(shape("a b=1 &"), "a | b = 1.0");
}

#[test]
fn a_value_may_stand_on_the_line_behind_its_equals_sign() {
    assert_eq!(shape("a b = &\n 1 &\n c= & ! x\n(2)"), "a | b = 1.0 | c = (2.0)");
    // Without a mark it is read too, with one note per command.
    let text = "a b =\nbeam1 &\nc =\n3";
    assert_eq!(codes(text), [("syntax/continued-without-mark", "=")]);
    assert_eq!(
        common::statement(text, &flexure_syntax::command::parse(FileId(0), text).0[0]),
        "a | b = beam1 | c = 3.0"
    );
}

/// The help page of the beam prints its example so, with a placeholder where numbers belong.
#[test]
fn a_placeholder_with_blanks_is_reported_and_the_next_argument_is_read() {
    let text = "force modify beam &\nterms =\nany 6x6 table &\ni_marker =\nmarker_1 &\nj_marker =\nmarker_2\n";
    assert_eq!(codes(text), [("syntax/continued-without-mark", "="), ("syntax/stray-text", "6x6 table")]);
    assert_eq!(
        common::statement(text, &flexure_syntax::command::parse(FileId(0), text).0[0]),
        "force modify beam | terms = any | i_marker = marker_1 | j_marker = marker_2"
    );
}

#[test]
fn an_equals_sign_at_the_end_takes_neither_an_argument_nor_nothing() {
    assert_eq!(codes("a b =\nc = 3"), [("syntax/missing-value", "="), ("syntax/missing-keyword", "c")]);
    assert_eq!(codes("a b =\n\nmodel create"), [("syntax/missing-value", "=")]);
    assert_eq!(codes("a b ="), [("syntax/missing-value", "=")]);
}

#[test]
fn a_list_goes_on_behind_a_comma_and_before_one() {
    assert_eq!(shape("a b = 1, 2,3 &\n , 4, &\n 5 c=6"), "a | b = 1.0, 2.0, 3.0, 4.0, 5.0 | c = 6.0");
}

#[test]
fn a_word_behind_a_complete_value_begins_the_next_argument() {
    assert_eq!(shape("a b=word c=(1)d=\"x\"e=2"), "a | b = word | c = (1.0) | d = \"x\" | e = 2.0");
}

#[test]
fn numbers_are_read_in_every_form_and_keep_their_unit() {
    assert_eq!(
        shape("a b = 8,-3,+2.5,.05,-.5,5.,1.0E-002,2.07e+11,90d,-6.0E-06D,2cm,7801.0(kg/meter**3)"),
        "a | b = 8.0, -3.0, 2.5, 0.05, -0.5, 5.0, 0.01, 207000000000.0, 90.0<d>, -6e-6<D>, 2.0<cm>, 7801.0<kg/meter**3>"
    );
}

#[test]
fn an_infinite_number_is_refused() {
    assert_eq!(codes("a b = 1e400"), [("syntax/number-out-of-range", "1e400")]);
    assert_eq!(codes("a b = -1E400mm, 2"), [("syntax/number-out-of-range", "-1E400")]);
    assert_eq!(codes("a b = (2 * 1e999)"), [("syntax/number-out-of-range", "1e999")]);
}

#[test]
fn what_only_begins_like_a_number_is_a_word() {
    assert_eq!(shape("a b = 1/2, 3.2.1, 10-5, -, C:\\x.cmd"), "a | b = 1/2, 3.2.1, 10-5, -, C:\\x.cmd");
}

#[test]
fn names_keep_dots_quotes_and_wildcards() {
    assert_eq!(
        shape(r#"a b = .m."odd ! name, 2".x, "odd one".y, *, .m.left_*, .m.?[abc]{x,y}.cm, $part.cm"#),
        r#"a | b = .m."odd ! name, 2".x, "odd one".y, *, .m.left_*, .m.?[abc]{x,y}.cm, $part.cm"#
    );
    assert_eq!(shape("a b={x,y}* c=[1,2]"), "a | b = {x,y}* | c = [1,2]");
}

#[test]
fn strings_resolve_escapes_and_hide_marks_and_comments() {
    assert_eq!(
        shape(r#"a b="say \"hi\" \\ & ! x", '', 'it "is"', "C:\new" c="""#),
        r#"a | b = "say \"hi\" \\ & ! x", "", "it \"is\"", "C:\\new" | c = """#
    );
}

#[test]
fn a_string_may_span_lines() {
    assert_eq!(
        shape("script create cmds = &\n \"!\n! x &\nSTOP\n\" &\n name = b\nnext"),
        "script create | cmds = \"!\\n! x &\\nSTOP\\n\" | name = b ; next"
    );
}

#[test]
fn a_comment_starts_outside_quotes_and_parentheses_only() {
    assert_eq!(
        shape("if condition = (! db_exists(\"a\")) ! c\nend  ! of if"),
        "if | condition = ((! db_exists(\"a\"))) ; end"
    );
    assert_eq!(shape("a b=c!d"), "a | b = c");
}

#[test]
fn a_dotted_word_first_is_assigned_to() {
    assert_eq!(shape(".sim.alert=0\n.c.w = 0.9, &\n 0.8"), ".sim.alert := 0.0 ; .c.w := 0.9, 0.8");
    assert_eq!(codes(".a.b = 1 c = 2"), [("syntax/stray-text", "c = 2")]);
}

#[test]
fn line_ends_marks_of_byte_order_and_tabs_do_not_matter() {
    assert_eq!(shape("\u{feff}a\tb =\t1\t&\r\n\tc = 2\r\n\r\nd\r\n"), "a | b = 1.0 | c = 2.0 ; d");
}

#[test]
fn stray_text_is_reported_once_and_the_rest_is_read() {
    let text = "a b = 1 odd words \"here\" c = 2";
    assert_eq!(codes(text), [("syntax/stray-text", "odd words \"here\"")]);
    let (statements, diagnostics) = flexure_syntax::command::parse(FileId(0), text);
    assert_eq!(common::statement(text, &statements[0]), "a | b = 1.0 | c = 2.0");
    assert_eq!(diagnostics[0].adams_text, ["'odd' is not a valid parameter."]);
}

#[test]
fn forgotten_values_are_named() {
    assert_eq!(codes("a length = ixx = 4"), [("syntax/missing-value", "=")]);
    assert_eq!(codes("a b = 1,, 2"), [("syntax/missing-value", ",")]);
    assert_eq!(codes("a b = 1, c = 2"), [("syntax/missing-value", ",")]);
    assert_eq!(codes("a b = 1,"), [("syntax/missing-value", ",")]);
    assert_eq!(codes("a läng = é = 4"), [("syntax/missing-value", "=")]);
}

#[test]
fn what_is_never_closed_costs_its_command_and_nothing_else() {
    for (text, code, at) in [
        ("a b = \"open &\n c = 1\nmodel create", "syntax/unclosed-quote", "\""),
        ("a b = (1 + 2 &\n c = 1\nmodel create", "syntax/unclosed-parenthesis", "("),
        ("a b = (x // \"y) &\n c = \"z\"\nmodel create", "syntax/unclosed-quote", "\""),
        ("a b = .m.\"odd &\n c = 1\nmodel create", "syntax/unclosed-quote", "\""),
        ("a b = 5(kg &\n c = 1\nmodel create", "syntax/unclosed-parenthesis", "("),
    ] {
        assert_eq!(codes(text), [(code, at)], "{text}");
        let statements = flexure_syntax::command::parse(FileId(0), text).0;
        assert_eq!(statements.len(), 2, "{text}");
        assert_eq!(common::statement(text, &statements[1]), "model create");
    }
}

#[test]
fn a_backslash_before_the_last_quote_is_pointed_out() {
    let diagnostics = flexure_syntax::command::parse(FileId(0), r#"a b="C:\dir\""#).1;
    assert_eq!(diagnostics[0].code, "syntax/unclosed-quote");
    assert!(diagnostics[0].notes[0].contains("backslash"), "{diagnostics:?}");
}

#[test]
fn an_expression_without_parentheses_comes_with_its_fix() {
    let (_, diagnostics) = flexure_syntax::command::parse(FileId(0), "a b = sin(1) c = 2");
    assert_eq!(diagnostics.len(), 1);
    assert_eq!(diagnostics[0].code, "syntax/expression-without-parentheses");
    assert_eq!(diagnostics[0].helps[0].fix.as_ref().unwrap().replacement, "(sin(1))");
}

#[test]
fn misplaced_signs_are_reported() {
    assert_eq!(codes("a & b"), [("syntax/misplaced-continuation", "&")]);
    assert_eq!(codes(") x\nmodel create"), [("syntax/unexpected-token", ")")]);
    assert_eq!(codes("a \u{1} b"), [("syntax/unexpected-character", "\u{1}")]);
    assert_eq!(codes("length = 3"), [("syntax/missing-keyword", "length")]);
    assert_eq!(codes("(1)"), [("syntax/unexpected-token", "(")]);
}

#[test]
fn spans_give_the_text_back() {
    let text = "  force create beam &\n  name = .m.b , (1 + 2) ! end\n";
    let statement = &clean(text)[0];
    assert_eq!(&text[statement.span.range()], "force create beam &\n  name = .m.b , (1 + 2)");
    let flexure_syntax::command::StatementKind::Command { arguments, .. } = &statement.kind else { panic!() };
    assert_eq!(&text[arguments[0].value_span.range()], ".m.b , (1 + 2)");
}

#[test]
fn statements_are_pulled_one_by_one() {
    let mut parser = Parser::new(FileId(0), "a\nb c=1\n");
    assert_eq!(parser.next_statement().map(|(s, _)| s.span.range()), Some(0..1));
    assert!(parser.offset() <= 2);
    assert_eq!(parser.next_statement().map(|(s, _)| s.span.range()), Some(2..7));
    assert!(parser.next_statement().is_none() && parser.next_statement().is_none());
}

#[test]
fn comments_are_found_where_the_parser_skips_them() {
    let text = "! one  \r\na b=\"! no\" ! two\n if c=(!d) &! three\n e='! no' ! four\nf g=it's ! five\n";
    let found: Vec<_> = comments(FileId(0), text).map(|c| (&text[c.span.range()], c.own_line)).collect();
    assert_eq!(found, [("! one", true), ("! two", false), ("! three", false), ("! four", false), ("! five", false)]);
}
