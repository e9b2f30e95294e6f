package org.urbi.kernel.error;

import org.urbi.lang.problem.Template;

/**
 * The catalogue of what is added to errors of running code for people who look at a terminal, where
 * that depends on more than the {@linkplain Problem problem}.
 */
public enum Hint {
  FOREIGN_NAME("`{name}' is no name of urbiscript; it has `{meant}'"),
  FOREIGN_SLOT("{type} has no `{name}'; it has `{meant}'"),
  SINGLE_QUOTES("single quotes stand around names, double quotes around strings"),
  UNDECLARED("a new variable is declared by var: var {name} = …"),
  UNDECLARED_THERE(
      "a slot of the object is declared by var this.{name} = …, a variable by var {name} = …"),
  DICTIONARY_SET("a key gets a value in brackets: {dictionary}[\"{name}\"] = …"),
  UNDECLARED_EVENT("nothing is called `{name}' here: var {name} = Event.new declares an event"),
  UNDECLARED_TAG(
      "nothing is called `{name}' here: var {name} = Tag.new| {name}: { … } gives code that tag"),
  TAG_FUNCTION(
      "`{name}' is asked of a tag: t.{name}, where the code is t: { … }; break ends a loop"),
  UNDECLARED_SLOT("a new slot is declared by var: var {slot} = …"),
  LETTER_CASE("upper and lower case differ: here it is `{name}'"),
  DICTIONARY_KEY("the value of a key is read in brackets: dictionary[\"{name}\"]"),
  ENUMERATED("`{name}' is no value of {type}: {type}.values lists them"),
  NAMELESS_CALL("a function is called by its name: var f = function (x) { … }|; f(1)"),
  NOT_AN_ARROW("`->' is for properties: object.{name}(…) calls"),
  UNKNOWN_CLASS(
      "no class is called `{name}' here: is it written so? load(\"….u\"), loadModule(\"…\") bring some"),
  LOCAL_NAME("`{name}' was declared at {place}, and is known in those braces or statements only"),
  UNKNOWN_NAME("nothing is called `{name}' here: var {name} = … declares it"),
  UNKNOWN_FUNCTION("nothing is called `{name}' here: function {name}(…) { … } declares it"),
  OF_SESSION(
      "`{name}' is a slot of the session: a closure sees it; var Global.{name} is seen everywhere"),
  FILE_NAME("the name of a file is a string: load(\"file.u\")"),
  CAUGHT("what is caught is declared by var: catch (var {name}) { … }"),
  FOR_IN("a loop over elements is for (var {name} : list) …"),
  ASKED_OF_NIL("`{name}' was asked of nil: what should have a value has none"),
  ASKED_OF("`{name}' was asked of {a} {type}; allSlotNames lists what it has"),
  NO_EVENT("`!' emits events; a tag has stop, freeze and block"),
  NO_TAG_TO_STOP("tags are stopped: in `t: { … }' the code has the tag t, which t.stop stops"),
  FROZEN("`{name}' is frozen: this waits until {name}.unfreeze"),
  STILL_FROZEN("`{name}' is frozen, and stays so: new code of it waits until {name}.unfreeze"),
  BLOCKED("`{name}' is blocked: this is left out until {name}.unblock"),
  EMIT("an event is emitted by `{name}!(…)'"),
  NOT_DECLARED("`{name}' was not declared: its declaration failed at {place}"),
  NOT_DECLARED_IN_FILE(
      "`{name}' was not declared: its declaration failed at {place}; what else misses it is counted"),
  FOLLOWING("{count} more error{s} in {file} came of that, since these are missing: {names}"),
  NOT_LOADED("`{name}' may come from what was not loaded at {place}"),
  NO_RANGE(
      "{slot}'n is the place of {slot} in its range: first set {slot}->rangemin and {slot}->rangemax"),
  PRIME(
      "a single quote asks the value before it for a slot of that name; strings stand in double quotes"),
  NEW("`{name}' is a class: {name}.new(…) makes an object of it"),
  WITHOUT_ARGUMENTS("a name alone calls, and without arguments: {name}(…) gives it some"),
  INIT("`new' gives its arguments to `init' of {name}, which takes ({parameters})"),
  NO_INIT("`new' gives its arguments to `init', which {name} lacks: function init(…) { … }"),
  COMPARES("what sorts is asked of two elements: list.sort(function (a, b) { a > b })"),
  JOIN("a list joins its elements: [\"a\", \"b\"].join(\", \")"),
  CALLED_BY_NAME("a name alone calls: the function itself is closure (x) { {name}(x) }"),
  NUMBERS("`Math.{name}' takes {count} number{s}"),
  EVENT_CONDITION("an event is true as any object is: `{name}?' waits until it is emitted"),
  PARAMETERS("`{name}' takes ({parameters})"),
  TO_LIST("a list is written in brackets: [1]"),
  ADD_ELEMENT("`<<' adds one element; `{routine}' adds those of a list"),
  NO_ARGUMENTS("`{name}' takes no arguments: without parentheses it gives its value"),
  SHOW("echo(value) shows a value"),
  DURATION("a duration has no quotes: {value}"),
  ONE_VALUE("echo shows one value; `%' makes one string of several: echo(\"%s %s\" % [a, b])"),
  NIL("`null' is the channel that shows nothing; what stands for no value is nil"),
  CLASS_CALLED("`{name}()' is the class itself: {name}.new makes an object of it"),
  TO_NUMBER("asFloat makes a number of a string: \"12\".asFloat"),
  TO_STRING("asString makes a string of any value"),
  NO_TAG("`tag: code' gives code a tag; a dictionary is [\"key\" => value]"),
  NO_EXCEPTION("throw Exception.new(\"…\") tells where it was thrown");

  private final Template template;

  Hint(String text) {
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
