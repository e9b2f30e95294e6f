package org.urbi.kernel.script;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import javax.script.AbstractScriptEngine;
import javax.script.Bindings;
import javax.script.Invocable;
import javax.script.ScriptContext;
import javax.script.ScriptEngine;
import javax.script.ScriptException;
import javax.script.SimpleBindings;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.embed.UrbiValue;
import org.urbi.lang.source.Location;

/**
 * A kernel as a script engine (JSR 223). Its variables are the slots of its lobby; those of the
 * manager are inherited by it. Code evaluated with other bindings runs on an object that is created
 * from them, and whose slots are copied back to them. The output of background jobs goes to the
 * writer of the last evaluation.
 */
public final class UrbiScriptEngine extends AbstractScriptEngine
    implements Invocable, AutoCloseable {
  /** Names that the scripting platform uses for itself. */
  private static final String RESERVED = "javax.script.";

  private final UrbiScriptEngineFactory factory;
  private final Kernel kernel;
  private final UrbiValue globals;
  private final Set<String> globalNames = ConcurrentHashMap.newKeySet();
  private volatile Writer writer;

  UrbiScriptEngine(UrbiScriptEngineFactory factory) {
    this.factory = factory;
    this.writer = getContext().getWriter();
    this.kernel = Kernel.builder().output(this::print).start();
    this.globals = requireNonNull(kernel.eval("Object.new", UrbiValue.class), "a new object");
    UrbiValue lobby = kernel.embedding().lobby();
    lobby.call("addProto", globals);
    setBindings(new SlotBindings(lobby), ScriptContext.ENGINE_SCOPE);
  }

  private void print(String text) {
    Writer to = writer;
    try {
      to.write(text);
      to.flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The kernel that does the work. */
  public Kernel kernel() {
    return kernel;
  }

  @Override
  public UrbiScriptEngineFactory getFactory() {
    return factory;
  }

  @Override
  public Bindings createBindings() {
    return new SimpleBindings();
  }

  /** Ends the kernel. */
  @Override
  public void close() {
    kernel.close();
  }

  // ------------------------------------------------------------------ evaluation

  @Override
  public @Nullable Object eval(Reader reader, ScriptContext in) throws ScriptException {
    StringBuilder text = new StringBuilder();
    char[] chunk = new char[8192];
    try {
      for (int n = reader.read(chunk); n >= 0; n = reader.read(chunk)) {
        text.append(chunk, 0, n);
      }
    } catch (IOException e) {
      throw new ScriptException(e);
    }
    return eval(text.toString(), in);
  }

  @Override
  public @Nullable Object eval(String script, ScriptContext in) throws ScriptException {
    writer = in.getWriter();
    try {
      String file = in.getAttribute(ScriptEngine.FILENAME) instanceof String name ? name : null;
      Bindings variables = in.getBindings(ScriptContext.ENGINE_SCOPE);
      inherit(in.getBindings(ScriptContext.GLOBAL_SCOPE));
      if (variables instanceof SlotBindings own) {
        return evaluate(script, file, own.object());
      }
      UrbiValue scope = kernel.embedding().newScope();
      variables.forEach((name, value) -> {
        if (!name.startsWith(RESERVED)) {
          scope.set(name, value);
        }
      });
      try {
        return evaluate(script, file, scope);
      } finally {
        variables.putAll(new SlotBindings(scope));
      }
    } catch (UrbiError e) {
      throw scriptException(e);
    } catch (IllegalStateException | IllegalArgumentException e) {
      throw new ScriptException(e);
    }
  }

  private @Nullable Object evaluate(String script, @Nullable String file, UrbiValue target) {
    return kernel.embedding().eval(script, file, target, Object.class);
  }

  /**
   * Makes the variables of the manager visible, except those that cannot be converted. No monitor
   * is held: the kernel's thread may come here, too, for which the others wait.
   */
  private void inherit(@Nullable Bindings all) {
    if (all == null) {
      return;
    }
    for (String name : globalNames) {
      if (!all.containsKey(name) && globalNames.remove(name)) {
        globals.remove(name);
      }
    }
    // After those that are gone: what another thread has put there meanwhile is there at the end.
    for (Map.Entry<String, Object> variable : all.entrySet()) {
      try {
        globals.set(variable.getKey(), variable.getValue());
        globalNames.add(variable.getKey());
      } catch (IllegalArgumentException e) {
        // An object for other languages.
      }
    }
  }

  private static ScriptException scriptException(UrbiError e) {
    Location place = e.location();
    ScriptException exception =
        place == null
            ? new ScriptException(e.getMessage())
            : new ScriptException(e.getMessage(), place.file(), place.line(), place.column()) {
              private static final long serialVersionUID = 1;

              @Override
              public @Nullable String getMessage() {
                // The text contains the location already.
                return e.getMessage();
              }
            };
    exception.initCause(e);
    return exception;
  }

  // ------------------------------------------------------------------ calls

  @Override
  public @Nullable Object invokeFunction(String name, Object... arguments)
      throws ScriptException, NoSuchMethodException {
    return invoke(kernel.embedding().lobby(), name, arguments);
  }

  @Override
  public @Nullable Object invokeMethod(Object target, String name, Object... arguments)
      throws ScriptException, NoSuchMethodException {
    if (!(target instanceof UrbiValue object)) {
      throw new IllegalArgumentException("no object of urbiscript: " + target);
    }
    return invoke(object, name, arguments);
  }

  private static @Nullable Object invoke(UrbiValue target, String name, Object[] arguments)
      throws ScriptException, NoSuchMethodException {
    try {
      if (!understands(target, name)) {
        throw new NoSuchMethodException(name);
      }
      return target.call(name, arguments == null ? new Object[0] : arguments);
    } catch (UrbiError e) {
      throw scriptException(e);
    } catch (IllegalStateException e) {
      throw new ScriptException(e);
    }
  }

  private static boolean understands(UrbiValue target, String name) {
    return Boolean.TRUE.equals(target.call("hasSlot", name));
  }

  @Override
  public <T> @Nullable T getInterface(Class<T> type) {
    return getInterface(kernel.embedding().lobby(), type);
  }

  @Override
  public <T> @Nullable T getInterface(Object target, Class<T> type) {
    if (!(target instanceof UrbiValue object)) {
      throw new IllegalArgumentException("no object of urbiscript: " + target);
    }
    return InterfaceProxy.of(object, type, UrbiScriptEngine::understands);
  }
}
