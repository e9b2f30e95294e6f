package org.urbi.bench;

import java.util.List;

/**
 * A row of the table: a program and how to measure it.
 *
 * @param program the name of its folder
 * @param title what one operation is
 * @param operations how many of them one run of it does; its time is divided by that
 * @param based whether the time of its function {@code base} is to be taken off first
 * @param languages in which it may exist, besides urbiscript
 */
record Row(
    String program,
    String title,
    int operations,
    boolean based,
    List<Language> languages,
    Target target) {

  private static final List<Language> SCRIPTS =
      List.of(Language.PYTHON, Language.LUA, Language.LUAJIT);
  private static final List<Language> ALL = List.of(Language.PYTHON, Language.LUA, Language.BARE);
  private static final Target PYTHON = new Target.Ratio(Language.PYTHON, 1);

  /** What no program may take more of, to Lua. */
  private static final double WORST = 1.5;

  private static final Target NONE = new Target.None();

  private static Target atMost(double nanoseconds) {
    return new Target.Absolute(nanoseconds, Unit.TIME);
  }

  private static Row program(String name, String title, Target target) {
    return new Row(name, title, 1, false, SCRIPTS, target);
  }

  /** The same without any other language. */
  Row alone() {
    return new Row(program, title, operations, based, List.of(), target);
  }

  /** Programs as people write them, in the order of the table: {@code bench/everyday}. */
  static List<Row> everyday() {
    return List.of(
        everyday("sieve", "sieve"),
        everyday("queens", "queens"),
        everyday("permute", "permute"),
        everyday("towers", "towers"),
        everyday("bounce", "bounce"),
        everyday("nbody", "nbody"),
        everyday("mandelbrot", "mandelbrot"),
        everyday("trees", "binary trees"),
        everyday("list-recursion", "list recursion"),
        everyday("list-slices", "lists apart, together"),
        everyday("tasks", "tasks"),
        everyday("strings", "strings"),
        everyday("dictionaries", "dictionaries"),
        everyday("closures", "closures"),
        everyday("exceptions", "exceptions, 5 frames up"),
        everyday("errors", "errors of the language"),
        everyday("choices", "switch, patterns"),
        everyday("pipeline", "map, filter, fold, sort"),
        everyday("matrices", "matrix multiplication"),
        everyday("shapes", "polymorphic calls"),
        everyday("lazy", "lazy arguments"),
        everyday("variadic", "variadic calls"),
        everyday("globals", "globals"),
        everyday("particles", "particles"),
        everyday("conversions", "conversions, isA, assert"));
  }

  private static Row everyday(String name, String title) {
    return new Row(name, title, 1, false, SCRIPTS, new Target.Ratio(Language.LUA, WORST));
  }

  /** Single constructs, in the order of the table: {@code bench/programs}. */
  static List<Row> constructs() {
    return List.of(
        program("fib", "fib(25)", PYTHON),
        program("loop", "while| to 1e6", PYTHON),
        program("sum", "for| over 1e6", PYTHON),
        program("call", "1e6 method calls", PYTHON),
        program("slot", "1e6 o.x = o.x + 1", PYTHON),
        program("list-append", "1e5 list appends", PYTHON),
        program("list-iterate", "1e5 list elements", PYTHON),
        program("string", "1e4 string appends", NONE),
        program("object", "1e5 objects made", NONE),
        program("dictionary", "1e5 dictionary updates", NONE),
        program("set-slot", "49152 setSlot on one object", atMost(300e6)),
        program("try", "1e4 try/catch", NONE),
        new Row("semicolon", "; alone", 1_000_000, true, List.of(), atMost(20)),
        new Row(
            "switch",
            "switch among 100 jobs",
            100_000,
            true,
            ALL,
            new Target.Ratio(Language.BARE, 1.5)),
        new Row("spawn", "for& of 1e4 jobs", 1, false, ALL, atMost(60e6)),
        new Row("event-1", "event, 1 handler", 10_000, false, SCRIPTS, atMost(2e3)),
        new Row("event-100", "event, 100 handlers", 100, false, SCRIPTS, atMost(60e3)),
        new Row("change", "change seen by one at", 10_000, false, List.of(), atMost(2e3)));
  }
}
