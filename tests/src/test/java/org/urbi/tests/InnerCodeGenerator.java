package org.urbi.tests;

import java.util.List;

/**
 * Makes statements, too, that the interpreter executes from inside of compiled functions, and that
 * have variables of their own: branches, local functions, patterns, handlers of events, and code
 * that is evaluated by others.
 */
abstract class InnerCodeGenerator extends FunctionGenerator {
  /** What such statements use. */
  static final String INNER_PRELUDE =
      """
      var event = Event.new|; var mark = Tag.new|;
      function evaluated { call.evalArgAt(0) }|;
      function evaluatedTwice { [call.evalArgAt(0), call.evalArgAt(0)] }|;
      var handed = nil|; function handOut { handed = call | 0 }|;
      function handedOut() { var c = handed | handed = nil | if (c.isNil) 0 else c.evalArgAt(0) }|;
      """;

  /** How many loops are around what is being made, which it can leave. */
  int loops;

  /** How many pieces of code with variables of their own are around what is being made. */
  private int inner;

  InnerCodeGenerator(long seed) {
    super(seed);
  }

  /** Whether the variables of what is being made are those of code that is not compiled. */
  boolean isInner() {
    return inner > 0;
  }

  /** A statement with code that has variables of its own. */
  String innerCode() {
    return switch (random.nextInt(21)) {
      case 0, 1 -> branchOfEach();
      case 2, 3 -> "{ " + own() + " & " + own() + one("", " & " + own()) + " }";
      case 4 -> "{ " + own() + ", " + own() + one("", ", sleep(1ms)") + " }";
      case 5 -> declarationsAtOnce();
      case 6, 7 -> localFunction();
      case 8 -> patterns();
      case 9 -> caught();
      case 10 -> handler();
      case 11 -> {
        String element = fresh();
        yield "[1, 2].each(closure (" + element + ") " + apart(element) + ")";
      }
      case 12 -> one("evaluated", "evaluatedTwice", "detach") + "(" + apart() + ")";
      case 13 -> "{ { mark: " + own() + " } & { sleep(1ms) | mark.stop } }";
      case 14 -> one("do (Object.new) ", "stopif (o.x > 5) ", "Tag.new: ") + own();
      case 15, 16 -> scopes();
      case 17 -> "handOut(" + one("detach(" + apart() + ")", "scopeTag", apart()) + ")";
      case 18 -> loops > 0 ? "{ handedOut() | break }" : "echo(handedOut())";
      case 19 -> "handedOut()";
      default -> "timeout (3ms) every" + one("", "|") + " (1ms) " + apart();
    };
  }

  private String fresh() {
    return "v" + names++;
  }

  /**
   * A block with variables of its own. Mostly it uses no others, so that the function around it may
   * have none.
   *
   * @param given the variables that it has from the start
   */
  private String own(String... given) {
    List<String> outer = List.copyOf(variables);
    if (chance(65)) {
      variables.clear();
    }
    variables.addAll(List.of(given));
    inner++;
    String declared = chance(60) ? declaration(1) + one("; ", "| ") : "";
    String body = inside(nested > 3 ? 1 : 1 + random.nextInt(2));
    inner--;
    variables.clear();
    variables.addAll(outer);
    return "{ " + declared + body.substring(1);
  }

  /** The same for code that cannot leave the loops around it. */
  private String apart(String... given) {
    int around = loops;
    loops = 0;
    String body = own(given);
    loops = around;
    return body;
  }

  private String branchOfEach() {
    String element = fresh();
    loops++;
    String body = own(element);
    loops--;
    return "for& (var " + element + " : " + one("3", "2", "[1, \"x\", o.x]", "[]") + ") " + body;
  }

  /** Each of the variables exists before the job that declares it comes to that. */
  private String declarationsAtOnce() {
    String first = fresh();
    String second = fresh();
    String declarations =
        "var " + first + " = " + expression(1) + " & var " + second + " = " + expression(1);
    return "{ " + declarations + " | echo([" + first + ", " + second + "]) }";
  }

  private String localFunction() {
    String name = "g" + names++;
    String parameter = fresh();
    boolean given = chance(60);
    String body = given ? apart(parameter) : apart();
    String call = name + "(" + (given ? expression(1) : "") + ")";
    return "{ function "
        + name
        + "("
        + (given ? parameter : "")
        + ") "
        + body
        + "| "
        + one(call, "echo(" + call + ")", "for| (12) " + call, "{ " + call + " & " + call + " }")
        + " }";
  }

  private String patterns() {
    String first = fresh();
    String second = fresh();
    String value = one(expression(1), "[" + expression(1) + ", o.x]", "[1, [2, o.x]]");
    return "switch ("
        + value
        + ") { case [var "
        + first
        + ", var "
        + second
        + "]"
        + one("", " if " + first + " == 1")
        + ": "
        + own(first, second)
        + "; case var "
        + first
        + " if "
        + first
        + " == 1: "
        + own(first)
        + "; default: "
        + own()
        + " }";
  }

  /** A tag of a scope, of which a job is told that goes on for longer, or a handler. */
  private String scopes() {
    String tag = "t" + names++;
    String value = fresh();
    return one(
        "{ var " + tag + " = scopeTag| detach({ " + tag + ": { sleep(2ms) | " + apart() + " } }) }",
        "{ scopeTag: at (event?(var " + value + ")) " + apart(value) + "| event!(o.x) }",
        "{ handOut(scopeTag)| "
            + own()
            + "| var "
            + tag
            + " = handedOut()| try { detach({ "
            + tag
            + ": { sleep(2ms) | echo(1) } }) } catch { echo(2) } }");
  }

  private String caught() {
    String first = fresh();
    String second = fresh();
    return "try { "
        + own()
        + "| throw "
        + one("[1, o.x]", "o.x", expression(1))
        + " } catch ([var "
        + first
        + ", var "
        + second
        + "]) "
        + own(first, second)
        + " catch (var "
        + first
        + ") "
        + own(first);
  }

  /** Each time with another event, so that the handlers of before have nothing to do any more. */
  private String handler() {
    String value = fresh();
    String emitted = "event!(" + expression(1) + ")";
    String waiting =
        chance(30)
            ? "timeout (3ms) { waituntil (event?(var " + value + ")) | " + apart(value) + " }"
            : "at"
                + one("", " sync", " async")
                + " (event?(var "
                + value
                + ")) "
                + apart(value)
                + one("", " onleave " + apart(value));
    return "{ event = Event.new | { " + waiting + " } & { " + emitted + " } | sleep(1ms) }";
  }
}
