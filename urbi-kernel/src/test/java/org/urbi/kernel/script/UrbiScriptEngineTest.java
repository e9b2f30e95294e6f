package org.urbi.kernel.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.StringReader;
import java.io.StringWriter;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.FutureTask;
import java.util.function.DoubleUnaryOperator;
import javax.script.Bindings;
import javax.script.ScriptContext;
import javax.script.ScriptEngine;
import javax.script.ScriptEngineManager;
import javax.script.ScriptException;
import javax.script.SimpleBindings;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.embed.UrbiValue;
import org.urbi.kernel.log.FailureLog;

class UrbiScriptEngineTest {
  private final ScriptEngineManager manager = new ScriptEngineManager();
  private UrbiScriptEngine engine;

  @BeforeEach
  void start() {
    engine = (UrbiScriptEngine) manager.getEngineByName("urbiscript");
  }

  @AfterEach
  void stop() {
    engine.close();
  }

  @Test
  void itIsFoundByExtensionAndType() {
    ScriptEngine other = manager.getEngineByExtension("u");
    assertInstanceOf(UrbiScriptEngine.class, other);
    ((UrbiScriptEngine) other).close();
    assertEquals("2.7", engine.getFactory().getLanguageVersion());
    assertEquals("MULTITHREADED", engine.getFactory().getParameter("THREADING"));
  }

  @Test
  void variablesAreSlotsOfTheLobby() throws ScriptException {
    engine.put("x", 20);
    assertEquals(42.0, engine.eval("var y = x * 2 + 2; y"));
    assertEquals(42.0, engine.get("y"));
    engine.put("x", List.of("a"));
    assertEquals(List.of("a"), engine.eval("x"));
    Bindings variables = engine.getBindings(ScriptContext.ENGINE_SCOPE);
    assertEquals(Map.of("x", List.of("a"), "y", 42.0), new HashMap<>(variables));
    variables.clear();
    assertNull(engine.get("y"));
    assertThrows(ScriptException.class, () -> engine.eval("y"));
    assertThrows(IllegalArgumentException.class, () -> engine.put("", 1));
  }

  @Test
  void otherBindingsHaveAnObjectOfTheirOwn() throws ScriptException {
    Bindings own = new SimpleBindings();
    own.put("x", 1);
    assertEquals(3.0, engine.eval("var y = x + 2; y", own));
    assertEquals(3.0, own.get("y"));
    assertEquals(4.0, engine.eval("y = x + 3; y", own));
    assertEquals(4.0, own.get("y"));
    assertFalse(engine.getBindings(ScriptContext.ENGINE_SCOPE).containsKey("y"));
    own.put("z", new Object());
    assertThrows(ScriptException.class, () -> engine.eval("1", own));
  }

  @Test
  void variablesOfTheManagerAreInherited() throws ScriptException {
    manager.put("shared", "s");
    manager.put("odd", new Object());
    assertEquals("s", engine.eval("shared"));
    assertEquals("s", engine.eval("shared", new SimpleBindings()));
    manager.getBindings().remove("shared");
    assertThrows(ScriptException.class, () -> engine.eval("shared"));
  }

  @Test
  void outputGoesToTheWriter() throws ScriptException {
    StringWriter writer = new StringWriter();
    engine.getContext().setWriter(writer);
    engine.eval(new StringReader(engine.getFactory().getOutputStatement("a \"ü\"\n\\") + ";"));
    assertEquals("*** a \"ü\"\n\\\n", writer.toString().replaceFirst("\\[\\d+\\] ", ""));
  }

  @Test
  void errorsHaveAPlace() {
    engine.put(ScriptEngine.FILENAME, "dir/input.u");
    ScriptException lookup = assertThrows(ScriptException.class, () -> engine.eval("\n foo"));
    assertEquals(
        "dir/input.u:2.2-4: lookup failed: foo (possible misspelling of log)", lookup.getMessage());
    assertEquals("dir/input.u", lookup.getFileName());
    assertEquals(2, lookup.getLineNumber());
    assertEquals(2, lookup.getColumnNumber());
    assertInstanceOf(UrbiError.class, lookup.getCause());
    ScriptException syntax = assertThrows(ScriptException.class, () -> engine.eval("1 +;"));
    assertEquals(1, syntax.getLineNumber());
  }

  /** Something for urbiscript to implement. */
  public interface Robot {
    int speed();

    String say(String text);

    default String greet() {
      return say("hello");
    }
  }

  @Test
  void functionsAreInvokedAndInterfacesImplemented() throws Exception {
    engine.eval("function applyAsDouble(x) { x * 2 }");
    assertEquals(4.0, engine.invokeFunction("applyAsDouble", 2));
    assertEquals(6.0, engine.getInterface(DoubleUnaryOperator.class).applyAsDouble(3));
    assertThrows(NoSuchMethodException.class, () -> engine.invokeFunction("missing"));
    assertThrows(ScriptException.class, () -> engine.invokeFunction("applyAsDouble", "x", 1));

    Object object =
        engine.eval("class R { function speed { 3 }; function say(t) { t + \"!\" } }; R");
    assertInstanceOf(UrbiValue.class, object);
    assertEquals("a!", engine.invokeMethod(object, "say", "a"));
    assertThrows(NoSuchMethodException.class, () -> engine.invokeMethod(object, "fly"));
    Robot robot = engine.getInterface(object, Robot.class);
    assertEquals(3, robot.speed());
    assertEquals("hello!", robot.greet());
    assertNull(engine.getInterface(object, Runnable.class));
    assertThrows(IllegalArgumentException.class, () -> engine.getInterface(String.class));
    assertThrows(IllegalArgumentException.class, () -> engine.invokeMethod(1, "x"));
  }

  @Test
  void afterTheEndThereIsAnException() {
    engine.close();
    assertThrows(ScriptException.class, () -> engine.eval("1"));
  }

  /** It is told that it must not, instead of waiting for a thread that waits for it. */
  @Test
  void theKernelsThreadIsRefusedWhileAnotherOneWaitsForIt() throws Exception {
    manager.put("shared", "s");
    FutureTask<Object> other = new FutureTask<>(() -> engine.eval("1", new SimpleBindings()));
    engine
        .kernel()
        .define(
            "nested",
            none -> {
              Thread waiting = FailureLog.THREADS.platform("waiting", other);
              waiting.start();
              while (!isInheriting(waiting)) {
                Thread.onSpinWait();
              }
              return assertThrows(ScriptException.class, () -> engine.eval("2")).getMessage();
            });
    String refused = String.valueOf(engine.eval("nested()"));
    assertTrue(refused.contains("the kernel thread cannot wait"), refused);
    assertEquals(1.0, other.get());
  }

  private static boolean isInheriting(Thread waiting) {
    return waiting.getState() != Thread.State.RUNNABLE
        && Arrays.stream(waiting.getStackTrace())
            .anyMatch(frame -> frame.getMethodName().equals("inherit"));
  }
}
