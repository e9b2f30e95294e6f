package org.urbi.kernel;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.library.Library;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/**
 * Values of every kind, each as the urbiscript expression that makes it. The names of files among
 * them lie in the working directory, which is made for the test, or nowhere.
 */
final class WrongValues {
  private static final String NUMBERS =
      """
      0
      1
      -1
      2
      7
      0.5
      -2.5
      255
      256
      2147483647
      2147483648
      -2147483649
      4294967296
      1e18
      -1e300
      1e-300
      inf
      -inf
      nan\
      """;

  private static final String STRINGS =
      """
      ""
      "x"
      "a b,c"
      "%s"
      "%1000000000d"
      "%5.3d %%"
      "%"
      "%|"
      "%1000000000.1000000000|"
      "a\\0b"
      "\\xff\\xc3"
      "("
      "[a-"
      "(a*)*b"
      "1+"
      "12"
      "0x1p3"
      "12:30"
      "2010-08-17 14:40:52"
      "9999999999-99-99"
      "missing/file"
      "/missing-root/urbi/file"
      "file"
      "folder"
      "localhost"
      "asString"
      "init"
      "protos"
      "constant"
      ("0123456789" * 1000)\
      """;

  private static final String COLLECTIONS =
      """
      []
      [1]
      [3, 1, 2]
      ["a", "b"]
      [1, "a", nil, [2]]
      [void.acceptVoid]
      {var wrongList = [1] | wrongList << wrongList | wrongList}
      {var wrongCycle = ["a"] | wrongCycle << [wrongCycle, 1] | wrongCycle}
      100.seq
      [("a", 1), ("b", 2)]
      [[1, 2], [3]]
      [=>]
      ["a" => 1, 2 => "b"]
      {var wrongDict = ["a" => 1] | wrongDict["d"] = wrongDict | wrongDict}
      ()
      (1,)
      (1, "b")
      {var wrongTuple = (1, [2]) | wrongTuple[1] << wrongTuple | wrongTuple}
      Pair.new(1, [2])
      Triplet.new(1, nil, 3)\
      """;

  private static final String FUNCTIONS =
      """
      function () { 1 }
      function (x) { x }
      function (x) { true }
      function (x, y) { y }
      function (x, y) { nil }
      function (x, y, z) { }
      function (var a, var b = 2) { [a, b] }
      function (x[]) { x }
      function { call.argsCount }
      closure (x) { this }
      function (x) { throw Exception.new("thrown") }
      function (x) { sleep(1h) }
      function () { detach(sleep(inf)) | 1 }
      Float.getSlot("+")
      String.getSlot("split")
      List.getSlot("each&")
      Object.getSlot("new")\
      """;

  private static final String OBJECTS =
      """
      nil
      void
      true
      false
      Object.new
      Object.clone
      {var wrongThing = Object.clone | do (wrongThing) { var x = 1 } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { var protos = 12 } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { function asString() { 1 }; function asPrintable() { nil } } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { function asString() { throw Exception.new("asString") } } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { function '=='(x) { throw Exception.new("==") }; function '<'(x) { nil } } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { function hash() { nil }; function asList() { 12 } } | wrongThing}
      {var wrongThing = Object.clone | do (wrongThing) { function asBool() { "x" }; function each(f) { 1 }; function size() { -1 } } | wrongThing}
      {var wrongLoop = Object.new | wrongLoop.protos = [wrongLoop, Object] | wrongLoop}
      {var wrongParts = Object.new | wrongParts.setSlot("x", wrongParts) | wrongParts}
      lobby
      Lobby.create
      Global
      Tag.new("t")
      {var wrongTag = Tag.new | wrongTag.freeze | wrongTag}
      {var wrongTag = Tag.new("b") | wrongTag.block(1) | wrongTag}
      Tag.scope
      Timeout.new(1s)
      Event.new
      {var wrongEvent = Event.new | at (wrongEvent?(var x)) throw Exception.new("handler") | wrongEvent}
      Event.new.trigger(1)
      Barrier.new
      Mutex.new
      Semaphore.new(1)
      Semaphore.new(0)
      {var wrongJob = spawn(function () { sleep(inf) }, false) | wrongJob.terminate | wrongJob}
      spawn(function () { sleep(inf) }, false)
      Job.current
      Lazy.new(function () { 1 })
      Lazy.new(function () { throw Exception.new("lazy") })
      PseudoLazy.new(1)
      {function wrongCall { call } | wrongCall(1, missing)}
      Date.now
      Date.epoch
      Duration.new(1)
      Duration.new(-1e300)
      Enumeration.new("E", ["a", "b"])
      Enumeration.new("E", ["a", "b"]).a
      Regexp.new("a(b)?")
      Formatter.new("%s %d")
      FormatInfo.new("%5.2f")
      FormatInfo.new("%-08x")
      Binary.new("jpeg 2 3", "abc")
      Binary.new("", "")
      Group.new(1, "x")
      Group.new
      "x".hash
      Location.new(Position.new(1, 2))
      Position.new("f", 2147483647, 1)
      StackFrame.new("f", Location.new)
      Channel.new("c")
      Logger.new("wrong")
      UVar.new(Object.new, "x")
      PubSub.new
      PubSub.new.subscribe
      Server.new
      Socket.new
      IoService.new
      Finalizable.new
      Loadable.new
      profile(function () { 1 })
      Exception.new("message")
      Exception.Lookup.new("x", 1)
      Exception.Arity.new("f", 1, 2)
      Exception.Type.new(1, String)
      Exception.Argument.new("f", 1, Exception.new("x"))
      Exception.BadNumber.new("f", "%s", 1)
      {try { 1.wrong(2) } catch (var wrong) { wrong }}
      {File.save("file", "a b") | Path.new("file")}
      Path.new("missing/file")
      Path.new("folder")
      Path.new("folder/deep")
      Path.new("/missing-root/urbi")
      {File.save("file", "a b") | File.new("file")}
      {var wrongFile = File.create("lost") | wrongFile.remove | wrongFile}
      Directory.createAll("folder/deep")
      InputStream.new(File.create("in"))
      {var wrongStream = InputStream.new(File.create("in")) | wrongStream.close | wrongStream}
      {var wrongStream = OutputStream.new(File.create("out")) | wrongStream.close | wrongStream}
      Process.new("missing/program", [])
      Process.new("true", [])\
      """;

  /** What an own slot of an object, not a shared one, is read from; by name of its type. */
  private final List<String> expressions = new ArrayList<>();

  private final Map<String, List<String>> ofType = new LinkedHashMap<>();
  private final Map<String, String> kinds = new HashMap<>();
  private final int numbers;
  private final int strings;

  WrongValues() {
    NUMBERS.lines().forEach(expressions::add);
    numbers = expressions.size();
    STRINGS.lines().forEach(expressions::add);
    strings = expressions.size();
    COLLECTIONS.lines().forEach(expressions::add);
    FUNCTIONS.lines().forEach(expressions::add);
    OBJECTS.lines().forEach(expressions::add);
    for (BuiltinTable table : Library.declarations()) {
      // The prototype of paths is the path of the root.
      if (!table.isPart() && !table.type().equals("Path")) {
        expressions.add(table.type());
      }
    }
  }

  /** What prepares a kernel in which the values can be made. */
  static final String PREPARATION =
      "{ File.save(\"file\", \"a b\") | Directory.createAll(\"folder/deep\") }";

  List<String> expressions() {
    return expressions;
  }

  /** Remembers of what types a value is. */
  void learn(World world, String expression, UrbiObject value) {
    StringBuilder kind = new StringBuilder(value.getClass().getName());
    for (BuiltinTable table : Library.declarations()) {
      UrbiObject type = world.prototype(table.type());
      if (type != null && value.isA(type)) {
        List<String> known = ofType.computeIfAbsent(table.type(), name -> new ArrayList<>());
        if (!known.contains(expression)) {
          known.add(expression);
        }
        kind.append(' ').append(table.type());
      }
    }
    if (!expression.startsWith("{")) {
      kinds.put(expression, kind.toString());
    }
  }

  /** Whether a value is known to be of that type. */
  boolean isOfType(String expression, String type) {
    List<String> known = ofType.get(type);
    return known != null && known.contains(expression);
  }

  /** What a value has in common with all that a declaration cannot tell from it. */
  String kind(String expression) {
    return kinds.getOrDefault(expression, expression);
  }

  /** Any value. */
  String any(SplittableRandom random) {
    return switch (random.nextInt(5)) {
      case 0 -> expressions.get(random.nextInt(numbers));
      case 1 -> expressions.get(random.nextInt(numbers, strings));
      default -> expressions.get(random.nextInt(expressions.size()));
    };
  }

  /** A value of that type, if there is one. */
  String of(String type, SplittableRandom random) {
    List<String> known = ofType.get(type);
    return known == null ? any(random) : known.get(random.nextInt(known.size()));
  }
}
