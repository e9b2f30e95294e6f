package org.urbi.kernel.node;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;
import org.urbi.lang.source.Span;

/** What compiled code does with its frame: variables, errors, code that is not compiled. */
abstract class FrameAccess extends Node {
  /** How many plain variables there are in a frame. */
  public static int variables(Frame frame) {
    return locals(frame).length;
  }

  /** The variables in the frame; there is room for them from now on. */
  protected static UrbiObject[] locals(Frame frame) {
    return frame.room();
  }

  /** The value of a variable in the frame. */
  protected static UrbiObject local(UrbiObject[] locals, int index, UrbiObject nothing) {
    @Nullable UrbiObject value = locals[index];
    if (value instanceof SharedLocal shared) {
      return shared.get();
    }
    return value == null ? nothing : value;
  }

  // Loops have much of what follows: the Java machine puts methods of 35 bytes of code at most into
  // their callers there, so what is rare is on its own.

  /** The value of a variable in the frame. */
  protected static UrbiObject read(Frame frame, int index) {
    return frame.isSharing() ? readShared(frame, index) : given(locals(frame)[index], frame);
  }

  private static UrbiObject readShared(Frame frame, int index) {
    return local(locals(frame), index, frame.interpreter.values().voidObject);
  }

  private static UrbiObject given(@Nullable UrbiObject value, Frame frame) {
    return value == null ? frame.interpreter.values().voidObject : value;
  }

  /** Writes a pair to a variable in the frame; returns the object, which it has from now on. */
  protected static UrbiObject write(
      double number, @Nullable UrbiObject object, Frame frame, int index) {
    UrbiObject value = object(number, object, frame.interpreter.values());
    set(frame, index, value);
    return value;
  }

  private static void set(Frame frame, int index, UrbiObject value) {
    UrbiObject[] locals = locals(frame);
    if (frame.isSharing()) {
      SharedLocal.store(locals, index, value);
    } else {
      locals[index] = value;
    }
  }

  /** Writes the first value of a variable, which nobody else can reach yet, and returns it. */
  protected static UrbiObject begin(
      double number, @Nullable UrbiObject object, Frame frame, int index) {
    UrbiObject value = object(number, object, frame.interpreter.values());
    locals(frame)[index] = value;
    return value;
  }

  protected static Job job(Frame frame) {
    return frame.job;
  }

  protected static UrbiObject self(Frame frame) {
    return frame.self;
  }

  /**
   * Whether others may read and assign the variables of the frame at any time.
   *
   * @param frame null if nobody has needed it until now
   */
  public static boolean isExposed(@Nullable Frame frame) {
    return frame != null && frame.isExposed();
  }

  /** An error that has no place yet gets that of a node, if there is one. */
  static UrbiException located(UrbiException exception, Frame frame, @Nullable Node at) {
    return at == null ? exception : frame.located(exception, at.span());
  }

  static UrbiException located(UrbiException exception, Frame frame, @Nullable Span at) {
    return at == null ? exception : frame.located(exception, at);
  }

  /** The object of a pair. */
  protected static UrbiObject object(double number, @Nullable UrbiObject object, Values values) {
    return object == null ? values.number(number) : object;
  }

  /** Throws an error if the value is void. */
  protected static void notVoid(UrbiObject value, Frame frame, @Nullable Node at) {
    try {
      frame.interpreter.notVoid(value);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  /** What is not compiled. */
  protected static UrbiObject execute(Node code, Frame frame, @Nullable Node at) {
    try {
      return code.execute(frame);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  protected static void yield(Job job, Frame frame, @Nullable Node at) {
    try {
      job.yield(frame, at);
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }

  protected static void checkInterrupted(Job job, Frame frame, @Nullable Node at) {
    try {
      job.checkInterrupted();
    } catch (UrbiException e) {
      throw located(e, frame, at);
    }
  }
}
