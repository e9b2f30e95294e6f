package org.urbi.builtins;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.Array;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BuiltinProcessorTest {
  private static final String IMPORTS =
      "package org.urbi.kernel.library; import org.urbi.builtins.*; import org.urbi.kernel.node.*;"
          + " import org.urbi.kernel.object.*; import java.util.List;";

  /** Compiles classes of the library: names and texts in turns. */
  private static InMemoryCompiler.Output compile(String... namesAndTexts) {
    Map<String, String> sources = KernelStubs.sources();
    for (int i = 0; i < namesAndTexts.length; i += 2) {
      sources.put("org.urbi.kernel.library." + namesAndTexts[i], IMPORTS + namesAndTexts[i + 1]);
    }
    return InMemoryCompiler.compile(sources);
  }

  private static InMemoryCompiler.Output compileMethod(String method) {
    return compile(
        "NumberType",
        "@UrbiType(value = \"Number\", doc = \"A number.\") final class NumberType {\n"
            + method
            + "\n}");
  }

  /** What is said of a class with three builtins, whose reference is a text. */
  private static List<String> errorsWithReference(Path folder, String text) throws IOException {
    Files.writeString(folder.resolve("Number.md"), text);
    Map<String, String> sources = KernelStubs.sources();
    sources.put(
        "org.urbi.kernel.library.NumberType",
        IMPORTS
            + """
            @UrbiType(value = "Number", doc = "A number.") final class NumberType {
              @Builtin(value = {"half", "/2"}, doc = "A half.")
              static double half(UrbiObject self) { return 1; }
              @Builtin(doc = "The double.") static double twice(UrbiObject self) { return 2; }
            }
            """);
    return InMemoryCompiler.compile(sources, "-Aurbi.reference=" + folder).errors().stream()
        .map(error -> error.replace(folder.toString(), "."))
        .toList();
  }

  @Test
  void aBuiltinWithoutAnExampleIsRefused(@TempDir Path folder) throws IOException {
    String complete =
        """
        # Number

        ### `half`, `/2`

        ```urbiscript
        ### `twice`
        4.half;
        ```

        ### `twice`

        ```urbiscript
        4.twice;
        ```
        """;
    assertEquals(List.of(), errorsWithReference(folder, complete));
    assertEquals(
        List.of("4: the reference has no example of `twice': ./Number.md"),
        errorsWithReference(folder, complete.replaceFirst("(?s)```urbiscript\n4.twice.*", "")));
    assertEquals(
        List.of(
            "3: the reference says nothing of `half': ### `half` in ./Number.md",
            "3: the reference says nothing of `/2': ### `/2` in ./Number.md"),
        errorsWithReference(folder, complete.replace("### `half`, `/2`", "## Halves")));
  }

  private static void refused(String expected, String method) {
    List<String> errors = compileMethod(method).errors();
    assertEquals(List.of("2: " + expected), errors);
  }

  /** A table that has been compiled and loaded. */
  private static final class Loaded {
    private final ClassLoader loader;
    private final Object table;

    Loaded(InMemoryCompiler.Output output, String name) throws Exception {
      assertEquals(List.of(), output.errors());
      loader = output.loader();
      Constructor<?> constructor =
          loader.loadClass("org.urbi.kernel.library." + name).getConstructors()[0];
      table =
          constructor.newInstance(
              Stream.of(constructor.getParameterTypes()).map(this::saysYes).toArray());
    }

    /** An implementation of an interface with one method, which returns true. */
    private Object saysYes(Class<?> needed) {
      return Proxy.newProxyInstance(
          loader, new Class<?>[] {needed}, (proxy, method, arguments) -> true);
    }

    Object number(double value) throws Exception {
      return loader
          .loadClass("org.urbi.kernel.object.UrbiFloat")
          .getConstructor(double.class)
          .newInstance(value);
    }

    double value(Object number) throws Exception {
      return (double) number.getClass().getField("value").get(number);
    }

    Object call(int index, Object self, Object... arguments) throws Exception {
      Object frame = loader.loadClass("org.urbi.kernel.node.Frame").getConstructor().newInstance();
      Class<?> object = loader.loadClass("org.urbi.kernel.object.UrbiObject");
      Object array = Array.newInstance(object, arguments.length);
      for (int i = 0; i < arguments.length; i++) {
        Array.set(array, i, arguments[i]);
      }
      for (Method method : table.getClass().getMethods()) {
        if (method.getName().equals("call") && method.getReturnType() == object) {
          try {
            return method.invoke(table, index, frame, null, self, array);
          } catch (InvocationTargetException e) {
            throw (Exception) e.getCause();
          }
        }
      }
      throw new AssertionError("no call");
    }
  }

  @Test
  void callsMethodsByTheirNames() throws Exception {
    Loaded t =
        new Loaded(
            compileMethod(
                """
                @Builtin(value = {"+", "plus"}, doc = "The sum.")
                static double plus(UrbiFloat self, double that) { return self.value + that; }
                @Builtin(doc = "Whether it is zero.")
                static boolean isZero(Frame f, CallSite s, UrbiFloat self) {
                  return self.value == 0;
                }
                @Builtin(doc = "Nothing.") static void nothing(UrbiObject self) {}
                """),
            "NumberTypeTable");
    assertEquals(
        "Number [+(that: Float):Float 1..1, plus(that: Float):Float 1..1, isZero:Boolean 0..0,"
            + " nothing:void 0..0]",
        t.table.toString());
    assertEquals(5, t.value(t.call(0, t.number(2), t.number(3))));
    assertEquals(5, t.value(t.call(1, t.number(2), t.number(3))));
    assertEquals(1, t.value(t.call(2, t.number(0))));
    assertEquals(null, t.call(3, t.number(0)));
  }

  @Test
  void givesNullForAbsentArgumentsAndTheRestAsAnArray() throws Exception {
    Loaded t =
        new Loaded(
            compileMethod(
                """
                @Builtin(doc = "Counts.")
                static int count(UrbiFloat self, UrbiFloat a, @Optional Integer b,
                    @Optional UrbiFloat c) {
                  return 1 + (b == null ? 0 : 10 * b) + (c == null ? 0 : 100);
                }
                @Builtin(doc = "Counts.")
                static int rest(UrbiFloat self, UrbiObject first, UrbiObject... more) {
                  return more.length;
                }
                @Builtin(doc = "A list.")
                static List<UrbiObject> list(UrbiFloat self) { return List.of(self, self); }
                """),
            "NumberTypeTable");
    assertEquals(
        "Number [count(a: Float, b?: Float, c?: Float):Float 1..3, rest(first, more...):Float 1..,"
            + " list:List 0..0]",
        t.table.toString());
    Object n = t.number(3);
    assertEquals(1, t.value(t.call(0, n, n)));
    assertEquals(31, t.value(t.call(0, n, n, n)));
    assertEquals(131, t.value(t.call(0, n, n, n, n)));
    assertEquals(0, t.value(t.call(1, n, n)));
    assertEquals(2, t.value(t.call(1, n, n, n, n)));
    assertEquals(2, t.value(t.call(2, n)));
  }

  @Test
  void checksTheTypesOfTheTargetAndOfTheArguments() throws Exception {
    Loaded t =
        new Loaded(
            compileMethod("@Builtin(doc = \"x.\") static void f(UrbiFloat self, UrbiFloat a) {}"),
            "NumberTypeTable");
    Object n = t.number(3);
    assertEquals(
        "0 is not a Float",
        assertThrows(IllegalArgumentException.class, () -> t.call(0, null, n)).getMessage());
    assertEquals(
        "1 is not a Float",
        assertThrows(IllegalArgumentException.class, () -> t.call(0, n, (Object) null))
            .getMessage());
  }

  @Test
  void splitsLargeTables() throws Exception {
    StringBuilder methods = new StringBuilder();
    for (int i = 0; i < 2 * TableWriter.CASES + 1; i++) {
      methods.append(
          String.format(
              "@Builtin(value = {\"f%d\", \"g%d\"}, doc = \"x.\")"
                  + " static int f%d(UrbiFloat self) { return %d; }%n",
              i, i, i, i));
    }
    Loaded t = new Loaded(compileMethod(methods.toString()), "NumberTypeTable");
    for (int i = 0; i < 4 * TableWriter.CASES + 2; i++) {
      assertEquals(i / 2, t.value(t.call(i, t.number(0))));
    }
  }

  @Test
  void listsTheTablesInAlphabeticalOrderAndPartsAfterTheirTypes() {
    InMemoryCompiler.Output output =
        compile(
            "ListType",
            "@UrbiType(value = \"List\", doc = \"L.\") final class ListType {}",
            "ListSearch",
            "@UrbiTypePart(\"List\") final class ListSearch {}",
            "FloatType",
            "@UrbiType(value = \"Float\", doc = \"F.\", protos = {\"A\", \"B\"})"
                + " final class FloatType {"
                + " static UrbiObject newPrototype(World w) { return new UrbiFloat(0); } }");
    assertEquals(List.of(), output.errors());
    String index = output.sources().get("org.urbi.kernel.library.LibraryTables");
    int first = index.indexOf("FloatTypeTable()");
    int second = index.indexOf("ListTypeTable()");
    int third = index.indexOf("ListSearchTable()");
    assertTrue(0 < first && first < second && second < third, index);
    assertTrue(
        output
            .sources()
            .get("org.urbi.kernel.library.FloatTypeTable")
            .contains("return FloatType.newPrototype(world);"));
  }

  @Test
  void handsWhatIsNeededToWhoNeedsIt() throws Exception {
    InMemoryCompiler.Output output =
        compile(
            "Lamp",
            "public interface Lamp { boolean isOn(); }",
            "Bell",
            "public interface Bell { UrbiObject ring(); }",
            "LampType",
            "@UrbiType(value = \"Lamp\", doc = \"L.\") final class LampType {"
                + " private final Lamp lamp; private final Bell bell;"
                + " LampType(Lamp lamp, Bell bell) { this.lamp = lamp; this.bell = bell; }"
                + " UrbiObject newPrototype(World w) { return bell.ring(); }"
                + " @Builtin(doc = \"O.\") boolean isOn(UrbiObject self) { return lamp.isOn(); }"
                + " @Builtin(doc = \"T.\") static int two(UrbiObject self) { return 2; } }",
            "BellType",
            "@UrbiType(value = \"Bell\", doc = \"B.\") final class BellType {"
                + " private final Bell bell; BellType(Bell bell) { this.bell = bell; }"
                + " @Builtin(doc = \"R.\") UrbiObject ring(UrbiObject s) { return bell.ring(); } }");
    assertEquals(List.of(), output.errors());
    String index = output.sources().get("org.urbi.kernel.library.LibraryTables");
    assertTrue(
        index.contains("all(org.urbi.kernel.library.Bell bell, org.urbi.kernel.library.Lamp lamp)"),
        index);
    assertTrue(
        index.contains("BellTypeTable(bell)") && index.contains("LampTypeTable(lamp, bell)"));
    assertTrue(
        output
            .sources()
            .get("org.urbi.kernel.library.LampTypeTable")
            .contains("return builtins.newPrototype(world);"));
    Loaded loaded = new Loaded(output, "LampTypeTable");
    assertEquals(1, loaded.value(loaded.call(0, loaded.number(0))));
    assertEquals(2, loaded.value(loaded.call(1, loaded.number(0))));
  }

  @Test
  void refusesEmptyDocs() {
    refused("the doc is empty", "@Builtin(doc = \" \") static void f(UrbiObject self) {}");
    assertEquals(
        List.of("1: the doc is empty"),
        compile("N", "@UrbiType(value = \"N\", doc = \"\") final class N {}").errors());
  }

  @Test
  void refusesMethodsThatCannotBeCalled() {
    refused(
        "a builtin must be static, or its class have one constructor with parameters",
        "@Builtin(doc = \"x.\") void f(UrbiObject self) {}");
    refused(
        "a builtin must not be private",
        "@Builtin(doc = \"x.\") private static void f(UrbiObject self) {}");
    refused(
        "the target is missing: an UrbiObject, or a subclass of it",
        "@Builtin(doc = \"x.\") static void f(Frame caller) {}");
    refused(
        "the target is missing: an UrbiObject, or a subclass of it",
        "@Builtin(doc = \"x.\") static void f(double self) {}");
    refused(
        "the kind of this parameter is not known: java.lang.Thread",
        "@Builtin(doc = \"x.\") static void f(UrbiObject self, Thread t) {}");
    refused(
        "the kind of this parameter is not known: double",
        "@Builtin(doc = \"x.\") static void f(UrbiObject self, @Optional double t) {}");
    refused(
        "only the last arguments can be optional",
        "@Builtin(doc = \"x.\") static void f(UrbiObject s, @Optional Integer a, int b) {}");
    refused(
        "the kind of this result is not known: java.lang.Thread",
        "@Builtin(doc = \"x.\") static Thread f(UrbiObject self) { return null; }");
    refused(
        "a setter has one argument",
        "@Builtin(doc = \"x.\", setter = true) static void f(UrbiObject self) {}");
    refused(
        "a lazy builtin finds its arguments in the call site",
        "@Builtin(doc = \"x.\", lazy = true) static void f(UrbiObject self, int i) {}");
  }

  @Test
  void refusesDuplicates() {
    refused(
        "the slot Number.f is declared twice",
        "@Builtin(doc = \"x.\") static void f(UrbiObject s) {}"
            + " @Builtin(value = \"f\", doc = \"x.\") static void g(UrbiObject s) {}");
    assertEquals(
        List.of("1: the type N is declared twice"),
        compile(
                "N",
                "@UrbiType(value = \"N\", doc = \"x.\") final class N {}",
                "M",
                "@UrbiType(value = \"N\", doc = \"x.\") final class M {}")
            .errors());
  }

  @Test
  void refusesClassesThatAreNotWholeTypes() {
    assertEquals(
        List.of("1: no class declares the type N"),
        compile("N", "@UrbiTypePart(\"N\") final class N {}").errors());
    assertEquals(
        List.of("1: a class of builtins must be final"),
        compile("N", "@UrbiType(value = \"N\", doc = \"x.\") class N {}").errors());
    assertEquals(
        List.of("1: @Builtin outside a class with @UrbiType or @UrbiTypePart"),
        compile("N", "class N { @Builtin(doc = \"x.\") static void f(UrbiObject self) {} }")
            .errors());
  }
}
