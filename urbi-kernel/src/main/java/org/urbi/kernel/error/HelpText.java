package org.urbi.kernel.error;

import org.urbi.lang.problem.Template;

/** The catalogue of what {@code help} says beside the texts of the reference. */
public enum HelpText {
  OVERVIEW(
      """
      help("List") tells of a type, help("List.map") of a slot, help("every") of a keyword,
      help("--port") of an option, help(robot) and help("robot.move") of what is your own.
      help("keywords") lists the keywords. These are the types:\
      """),
  OF_SLOT("help(\"{type}.{slot}\") tells of one of them."),
  SEVERAL("Several types have `{name}'; ask for one of them:"),
  OBJECT("{type}, made from {prototype}, with these slots:"),
  UNKNOWN("nothing is known of `{topic}'; help without an argument says what there is"),
  UNKNOWN_BUT("nothing is known of `{topic}'; did you mean {others}?");

  private final Template template;

  HelpText(String text) {
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
