package org.urbi.kernel;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.library.Library;
import org.urbi.lang.parse.UrbiParser;

/**
 * Draws well-formed programs: statements of every kind, combined in every way, and calls of the
 * builtins with arguments that fit, mostly. All loops give way to others or end soon.
 */
final class RandomProgram {
  private static final List<String> NAMES = List.of("a", "b", "c", "d");
  private static final List<String> EVENTS = List.of("e", "g");
  private static final List<String> TAGS = List.of("t", "u");
  private static final List<String> TIMES = List.of("0s", "10ms", "50ms", "200ms", "1s");
  private static final List<String> OPERATORS =
      List.of("+", "-", "*", "/", "%", "==", "!=", "<", ">=", "===", "&&", "||", "<<", "in", "^");
  private static final List<String> FLAVORS = List.of("", "", ";", "|", "&");
  private static final List<String> SEPARATORS = List.of("; ", "; ", " | ", " & ", ", ");

  /** What ends the kernel, or lets a job stay when its client leaves, is meant to do so. */
  private static final Set<String> EXCEPTED =
      Set.of("System.shutdown", "System.reboot", "System._exit", "System.spawn");

  /** Names that all programs can use; the last one belongs to the lobby, not to a scope. */
  private static final String BEGINNING =
      "var a = 1 | var b = [1, 2, 3] | var c = \"text\" | var d = Object.new |"
          + " var e = Event.new | var g = Event.new | var t = Tag.new(\"t\") | var u = Tag.new |"
          + " function f(x, y = 2) { [x, y] } | do (d) { var x = 1; function m(z) { x = z } }|;\n";

  /** The names of builtins as they stand in source text. */
  private static final Map<String, String> SLOTS = new HashMap<>();

  private static final int DEEPEST = 3;

  private int made;
  private final SplittableRandom random;
  private final WrongValues values;
  private final List<WrongCaller.Builtin> builtins = new ArrayList<>();

  RandomProgram(SplittableRandom random, WrongValues values) {
    this.random = random;
    this.values = values;
    for (BuiltinTable table : Library.declarations()) {
      for (int i = 0; i < table.size(); i++) {
        var builtin = new WrongCaller.Builtin(table, i);
        if (!EXCEPTED.contains(builtin.toString())) {
          builtins.add(builtin);
        }
      }
    }
  }

  /** The next one. */
  Program next() {
    List<Program> statements = new ArrayList<>();
    int count = random.nextInt(2, 9);
    for (int i = 0; i < count; i++) {
      statements.add(
          new Program("", List.of(statement(0)), "", random.nextInt(4) == 0 ? ",\n" : ";\n"));
    }
    return new Program(BEGINNING, statements, "", "");
  }

  private String any(List<String> of) {
    return of.get(random.nextInt(of.size()));
  }

  private String name() {
    return any(NAMES);
  }

  private static Program piece(Object... texts) {
    List<Program> parts = new ArrayList<>();
    StringBuilder before = new StringBuilder();
    StringBuilder after = new StringBuilder();
    // A text belongs to the part behind it; the last one stands alone.
    for (Object text : texts) {
      if (text instanceof Program part) {
        parts.add(before.isEmpty() ? part : new Program(before.toString(), List.of(part), "", ""));
        before.setLength(0);
      } else {
        before.append(text);
      }
    }
    after.append(before);
    return new Program("", parts, "", after.toString());
  }

  // ------------------------------------------------------------------ statements

  /** Statements in braces. */
  private Program block(int depth) {
    return new Program("{ ", statements(depth + 1), any(SEPARATORS), " }");
  }

  private List<Program> statements(int depth) {
    List<Program> all = new ArrayList<>();
    int count = depth >= DEEPEST - 1 ? 1 : random.nextInt(1, 4);
    for (int i = 0; i < count; i++) {
      all.add(statement(depth));
    }
    return all;
  }

  /** The same for what can be left by a word. */
  private Program leaving(int depth, String word) {
    List<Program> all = new ArrayList<>(statements(depth + 1));
    if (random.nextBoolean()) {
      Program leave = piece("if (", test(), ") " + word);
      all.add(random.nextInt(all.size() + 1), leave);
    }
    return new Program("{ ", all, any(List.of("; ", " | ")), " }");
  }

  private Program loop(int depth) {
    return leaving(depth, any(List.of("break", "continue")));
  }

  private Program statement(int depth) {
    if (depth >= DEEPEST || random.nextInt(4) < depth) {
      return simple(depth);
    }
    return switch (random.nextInt(26)) {
      case 0 -> piece("if (", expression(depth), ") ", block(depth), " else ", block(depth));
      case 1 -> piece("for" + any(FLAVORS) + " (var i : ", expression(depth), ") ", block(depth));
      case 2 -> piece("for" + any(FLAVORS) + " (" + random.nextInt(4) + ") ", block(depth));
      case 3 ->
          piece("for" + any(List.of("", ";", "|")) + " (var i = 0; i < 3; i++) ", loop(depth));
      case 4 ->
          piece(
              "{ var n = 0 | while" + any(List.of("", ";", "|")) + " (n < 3) { n++ | ",
              loop(depth),
              " } }");
      case 5 ->
          piece("timeout (" + time() + ") loop { sleep(" + pause() + ") | ", loop(depth), " }");
      case 6 -> piece("timeout (1s) every (" + pause() + ") ", block(depth));
      case 7 ->
          piece(
              "at (" + any(EVENTS) + "?" + any(List.of("", "(var x)", "(1, _)", "(var x) if x")),
              random.nextInt(3) == 0 ? " ~ 50ms) " : ") ",
              block(depth),
              " onleave ",
              block(depth));
      case 8 ->
          piece("at" + any(List.of("", " sync", " async")) + " (", condition(), ") ", block(depth));
      case 9 -> piece("at (" + name() + "->changed?) ", block(depth));
      case 10 ->
          piece(
              any(List.of("", "t: ")) + "whenever (",
              condition(),
              ") { sleep(" + pause() + ") | ",
              block(depth),
              " }");
      case 11 ->
          piece("whenever (" + any(EVENTS) + "?) { sleep(" + pause() + ") | ", block(depth), " }");
      case 12 -> piece("timeout (500ms) waituntil (", condition(), ")");
      case 13 -> piece(any(TAGS) + ": ", block(depth));
      case 14 ->
          piece(
              "try ",
              block(depth),
              any(List.of(" catch (var x) ", " catch (var x if x.isA(Exception)) ", " catch ")),
              block(depth),
              " finally ",
              block(depth));
      case 15 -> piece("try ", block(depth), " catch (var x) { x.asString }");
      case 16 ->
          piece(
              any(List.of("function ", "var ")).equals("var ")
                  ? "var v" + ++made + " = closure (x, y = 1) "
                  : "function v" + ++made + "(x, y = 1) ",
              leaving(depth, "return " + name()));
      case 17 ->
          piece(
              "class K" + ++made + " { var s = ",
              expression(depth),
              "; function m(x) ",
              leaving(depth, "return"),
              " }");
      case 18 -> piece("do (" + any(List.of("d", "a", "Object.new")) + ") ", block(depth));
      case 19 ->
          piece(
              "switch (",
              expression(depth),
              ") { case 1: ",
              block(depth),
              "; case var x if x == 2: ",
              block(depth),
              "; default: ",
              block(depth),
              " }");
      case 20 -> piece("stopif (", test(), ") { sleep(" + time() + ") | ", block(depth), " }");
      case 21 ->
          piece(
              "timeout (1s) freezeif (",
              test(),
              ") { sleep(" + time() + ") | ",
              block(depth),
              " }");
      case 22 -> piece("detach (", block(depth), ")");
      case 23 -> piece("spawn(closure () ", block(depth), ", false)");
      case 24 -> block(depth);
      default -> simple(depth);
    };
  }

  private Program simple(int depth) {
    return switch (random.nextInt(18)) {
      case 0 -> piece("var v" + ++made + " = ", expression(depth));
      case 1, 2 -> piece(name() + any(List.of(" = ", " += ", " -= ", " *= ")), expression(depth));
      case 3 -> piece(any(EVENTS) + "!(", expression(depth), ")");
      case 4 -> Program.of(any(EVENTS) + "!");
      case 5 ->
          Program.of(
              any(TAGS)
                  + any(
                      List.of(
                          ".stop",
                          ".freeze",
                          ".unfreeze",
                          ".block",
                          ".unblock",
                          ".stop(1)",
                          ".block(nil)")));
      case 6 -> Program.of("sleep(" + time() + ")");
      case 7 -> piece("throw ", expression(depth));
      case 8 -> Program.of("f(" + name() + ")");
      case 9 -> piece("echo(", expression(depth), ")");
      case 10 -> piece("d.x = ", expression(depth));
      case 11 -> Program.of(name() + any(List.of("++", "--")));
      case 12 -> piece("assert(", expression(depth), ")");
      case 13 -> piece("lobby.send(", expression(depth), ")");
      default -> expression(depth);
    };
  }

  private String time() {
    return any(TIMES);
  }

  /** A time in which something happens. */
  private String pause() {
    return any(TIMES.subList(2, TIMES.size()));
  }

  private Program test() {
    return switch (random.nextInt(3)) {
      case 0 -> Program.of(name() + " == 1");
      case 1 -> Program.of("d.x > 1");
      default -> expression(DEEPEST);
    };
  }

  /** A test or an event. */
  private Program condition() {
    return random.nextInt(4) == 0 ? Program.of(any(EVENTS) + "?(var p)") : test();
  }

  // ------------------------------------------------------------------ expressions

  private Program expression(int depth) {
    if (depth > DEEPEST + 1) {
      return Program.of(random.nextBoolean() ? name() : values.any(random));
    }
    return switch (random.nextInt(14)) {
      case 0, 1 -> Program.of(name());
      case 2, 3 -> Program.of(values.any(random));
      case 4 ->
          piece("(", expression(depth + 1), " " + any(OPERATORS) + " ", expression(depth + 1), ")");
      case 5 -> piece(any(List.of("!", "-")) + "(", expression(depth + 1), ")");
      case 6 -> piece("[", expression(depth + 1), ", ", expression(depth + 1), "]");
      case 7 -> piece("f(", expression(depth + 1), ")");
      case 8 -> piece("(", expression(depth + 1), ")[", expression(depth + 1), "]");
      case 9 -> piece("closure (x) ", block(Math.max(depth, DEEPEST - 1)));
      default -> call(depth);
    };
  }

  private static String inSource(String name) {
    boolean plain = UrbiParser.parse("1." + name + "(2);", null).errors().isEmpty();
    return plain && name.chars().allMatch(Character::isJavaIdentifierPart) && !name.contains("$")
        ? name
        : "'" + name + "'";
  }

  private Program call(int depth) {
    WrongCaller.Builtin builtin = builtins.get(random.nextInt(builtins.size()));
    BuiltinTable table = builtin.table();
    String slot = SLOTS.computeIfAbsent(table.name(builtin.index()), RandomProgram::inSource);
    String target = random.nextInt(8) == 0 ? name() : values.of(table.type(), random);
    List<Object> texts = new ArrayList<>();
    if (table.isSetter(builtin.index())) {
      return piece("(" + target + ")." + slot + " = ", expression(depth + 1));
    }
    int min = table.minArguments(builtin.index());
    int max = Math.min(table.maxArguments(builtin.index()), min + 2);
    int count = random.nextInt(12) == 0 ? max + 1 : random.nextInt(min, max + 1);
    texts.add("(" + target + ")." + slot);
    for (int i = 0; i < count; i++) {
      texts.add(i == 0 ? "(" : ", ");
      texts.add(expression(depth + 1));
    }
    if (count > 0) {
      texts.add(")");
    }
    return piece(texts.toArray());
  }
}
