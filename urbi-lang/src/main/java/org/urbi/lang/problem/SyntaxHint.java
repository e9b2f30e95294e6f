package org.urbi.lang.problem;

/**
 * The catalogue of what the parser's messages add for people who look at a terminal: what to do
 * about a mistake, where that depends on the text around it, and what the places are that are shown
 * with it. What holds for every text is the {@linkplain SyntaxProblem#hint() hint} of the problem.
 */
public enum SyntaxHint {
  // ------------------------------------------------------------------ words

  MISSPELLED("did you mean `{word}'?"),
  NO_WORD("`{word}' is no word of urbiscript; here it is `{meant}'"),
  LIKE_FUNCTION("a function without a name is `function (x) { x + 1 }', or `closure'"),
  CONSTANT("a constant is declared by const var {word} = …"),
  NO_THEN("`if (…) … else …' has no `then'"),
  NO_DO_WHILE("there is no do … while: loop { …; if (!condition) break }"),

  KEYWORD("`{word}' is a word of the language: choose another name"),
  NO_TYPES("names are declared without such words: var x = 1, function (x) { … }"),
  CONVERSION("asFloat makes a number of a string: \"12\".asFloat"),
  PROTOTYPE("a class names its prototype behind a colon: class {name} : Object { … }"),
  JOINED_NAMES("names are joined by a dot: {owner}.{name}"),
  IF_FIRST("`if' stands before what it decides: if (…) x = 1 else x = 2"),
  CAUGHT("what is caught is declared by var: catch (var {name}) { … }"),
  NO_BREAK("a case ends where the next one begins: it needs no `break'"),
  ASSERT_MESSAGE("an assertion with a message is System.assert_(x == 1, \"…\")"),
  COMPREHENSION("a list of what a function makes of others is list.map(function (x) { … })"),
  ARGUMENT_LIST("a list of arguments is given by apply: getSlot(\"{name}\").apply([this] + list)"),
  METHOD("a function of a class is function {name}(…) { … }; new calls the one named init"),
  ONLEAVE("what happens when it is over stands behind onleave: at (…) … onleave …"),
  INCLUDE("load(\"file.u\") runs another file"),
  COMMENT("a comment is // to the end of the line, or /* … */"),
  DEFAULT("all other cases of a switch stand behind `default:'"),
  NEEDLESS(
      "`{word}' is no word of urbiscript: without it, the function replaces the inherited one"),
  ACCESS("whoever has an object can use all of its slots: a class needs no `{word}:'"),
  IMPORTED("what {name} has is brought here by import {name}.*; files by load(\"file.u\")"),
  CATCH_ALL("catch { … } catches everything; catch (var e) { … } calls it e"),
  NAMED_ARGUMENTS(
      "arguments are given in their order, without names; one that is a function is function (x) { … }"),
  CARRIED("what an event carries is named in parentheses: at (event?(var x)) …"),
  COMMENTED_OUT("`//' begins a comment, with the `;' that would end the statement"),

  // ------------------------------------------------------------------ separators

  LOOP_PARTS("the parts of a loop are separated by `;': for (var i = 0; i < 3; i++)"),
  LOOP_COUNTS("a loop that counts is for (var i = 0; i < 3; i++) …"),
  LOOP_PAIRS(
      "a loop has one variable; that over a dictionary has pairs: for (var pair : dictionary) pair[1]"),
  SEPARATOR("`;' is missing at the end of the statement before it"),
  COMMA("elements and arguments are separated by `,'"),
  NO_SEMICOLON(
      "`{closer}' is missing before `;', or `,' was meant, as between elements and arguments"),
  TOGETHER("`;' or an operator is missing before it; a modifier is x = 1 time:2s"),
  ARGUMENTS("arguments stand in parentheses: {word}({argument})"),
  VALUE_OR_TEXT(
      "arguments stand in parentheses: {word}({argument}), or {word}(\"{argument}\") for that text"),
  NOTHING("something is missing between the parentheses of `{word}'"),
  ELSE("`else' directly follows its `if (…) …', without a `;' before it"),
  OPERAND("something is missing behind `{operator}'"),

  // ------------------------------------------------------------------ brackets

  PARENTHESES("what belongs to `{word}' stands in parentheses: {word} (…) …"),
  LOOP("a loop over elements is for (var x : list) …"),
  BLOCK("braces hold what belongs to `{word}': {word} … { … }"),
  CASES("the cases of a switch stand in braces: switch (x) { case 1: … }"),
  CASE_COLON("a `:' follows the value of a case"),
  CATCH("try { … } is followed by catch (var e) { … }, or by finally { … }"),
  UNOPENED("there is nothing open that `{closer}' could close"),
  UNCLOSED("`{closer}' is missing"),
  INDENTED("by its indentation, `{closer}' is missing here"),
  QUOTE("`\"' is missing at the end of a string"),

  // ------------------------------------------------------------------ operators

  ASSIGNMENT("a value is given by `='"),
  DIFFERENT("`!=' asks whether two values are different"),
  DICTIONARY("a dictionary is [\"key\" => value]"),
  DICTIONARY_PAIRS("all elements of a dictionary have a key and a value: [\"a\" => 1, \"b\" => 2]"),
  FORMAT("values are put into a string by `%': \"%s is %s\" % [name, value]"),
  CONCATENATION("strings are joined by `+'; a slot stands behind one dot"),
  UNIT_TOUCHES("a duration is one word: 500ms, 1.5s, 2min"),
  SLICE("a part of a string is text[0, 2], one of a list is list.range(0, 2)"),
  ONLY_EVENTS("`?' stands behind an event, in at (…), whenever (…) and waituntil (…)"),
  NO_CHOICE("there is no `? :'; if (…) x = 1 else x = 2 chooses"),
  RANGE("there are no ranges with dots: for (var i : 3) counts 0, 1, 2"),
  COLON("a `:' starts no block; braces do"),
  QUOTES("strings stand between double quotes: \"…\""),
  ASCII("names consist of the letters a to z, digits and _"),
  UNITS("the units of durations are d, h, min, s, ms, us and ns"),
  NUMBERS("numbers are written 12, 1.5, 1e-3 or 0xFF, with no letters behind them"),
  LETTER_FIRST("a name begins with a letter or _"),

  // ------------------------------------------------------------------ code that is valid

  COMPARISON("`=' gives a value, and the condition is that value; `==' compares"),
  COMPOSED(
      "`&' and `|' put statements together; conditions are joined by && and ||, bits by bitand"),
  ENDLESS("this does not end, and what is typed next waits for it: `,' at its end does not wait"),
  INTERPOLATED("`{text}' stays as it is in a string: \"it is %s\" % [{name}] puts in the value"),
  ONE_BY_ONE(
      "`{name},' is a statement of its own: names get their values one by one, x = 1; y = 2"),

  SIGN(
      "`=' and `{sign}' are two operators here, and give a value with a sign; `{sign}=' changes it"),
  VALUE("`{word}' is a value of the language; here and from now on the name stands for another"),

  // ------------------------------------------------------------------ the places that are shown

  OPENED("opened here"),
  ENDS("it ends here"),
  STRING_BEGINS("this string goes on to line {line}");

  private final Template template;

  SyntaxHint(String text) {
    template = new Template(text);
  }

  /** Its text, not filled in. */
  public Template template() {
    return template;
  }

  /** Its text; the values stand for its places, in their order. */
  public String text(Object... values) {
    return template.fill(values);
  }
}
