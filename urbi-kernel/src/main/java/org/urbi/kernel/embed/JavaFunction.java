package org.urbi.kernel.embed;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.builtin.BuiltinTable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.ControlFlowException;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.trust.Role;

/** A Java function of the embedding program, as a builtin. */
final class JavaFunction extends BuiltinTable {
  /** The urbiscript code that called the Java function which this thread is executing. */
  private static final ScopedValue<Frame> CALLER = ScopedValue.newInstance();

  private final Embedding embedding;
  private final Function<? super List<Object>, ?> body;

  JavaFunction(Embedding embedding, String name, Function<? super List<Object>, ?> body) {
    super(
        "Java",
        "",
        new String[0],
        new Entry[] {
          new Entry(
              name,
              0,
              Integer.MAX_VALUE,
              false,
              false,
              Role.USER,
              false,
              "(arguments...)",
              "",
              "Does what the program around the kernel says.")
        });
    this.embedding = embedding;
    this.body = body;
  }

  /** Who called the Java function which this thread is executing; null when it executes none. */
  static @Nullable Frame caller() {
    return CALLER.isBound() ? CALLER.get() : null;
  }

  @Override
  public UrbiObject call(
      int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    List<Object> values = new ArrayList<>(arguments.length);
    for (UrbiObject argument : arguments) {
      values.add(JavaValues.toJava(embedding, argument));
    }
    String outer = caller.job().componentCode().enter(name(0));
    try {
      Object result =
          ScopedValue.where(CALLER, caller)
              .call(() -> body.apply(Collections.unmodifiableList(values)));
      GivenValues given = new GivenValues(embedding);
      return new FromDataConverter(caller, given.objects()).object(given.value(result));
    } catch (UrbiException | ControlFlowException e) {
      throw e;
    } catch (UrbiError e) {
      if (e.original() != null) {
        throw e.original();
      }
      throw failure(caller, e);
    } catch (RuntimeException e) {
      throw failure(caller, e);
    } finally {
      caller.job().componentCode().leave(outer);
    }
  }

  private UrbiException failure(Frame caller, RuntimeException e) {
    String text = e.getMessage() == null ? e.getClass().getName() : e.getMessage();
    return caller.interpreter().errors().primitive(name(0), Problem.REASON, Utf8Text.toUrbi(text));
  }
}
