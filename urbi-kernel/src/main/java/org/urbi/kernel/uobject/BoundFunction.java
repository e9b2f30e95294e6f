package org.urbi.kernel.uobject;

import java.lang.invoke.MethodHandle;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.PermissionCheck;
import org.urbi.kernel.object.Shape;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.trust.Role;
import urbi.UCallback;

/** A function of a UObject, as urbiscript calls it (manual, "Binding functions"). */
final class BoundFunction extends Code {
  private final PluggedContext context;
  private final UCallback callback;
  private final int arity;

  /**
   * Converts the urbiscript arguments, calls the function and converts its result; null if that
   * cannot be combined.
   */
  private final @Nullable MethodHandle whole;

  private final CallStatistics.Entry statistics;
  private @Nullable String gone;

  BoundFunction(Shape shape, PluggedContext context, UCallback callback) {
    super(shape);
    this.context = context;
    this.callback = callback;
    this.arity = callback.arity();
    this.whole = callback.isThreaded() ? null : context.converters().whole(callback);
    this.statistics = context.statistics().entry(callback.name());
  }

  UCallback callback() {
    return callback;
  }

  /** The object has ended: from now on a call is an error with that reason. */
  void end(String why) {
    gone = why;
  }

  @Override
  public boolean isLazy() {
    return false;
  }

  @Override
  public UrbiObject cloned() {
    return new BoundFunction(cloneShape(), context, callback);
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    if (arguments.length != arity) {
      String called = site.isNamed() ? site.calledName() : callback.name();
      throw caller.interpreter().errors().arity(called, arguments.length, arity, arity);
    }
    if (!caller.job().isOwner()) {
      PermissionCheck.checkRole(caller, site.calledName(), Role.USER);
    }
    if (gone != null) {
      throw caller.error(site, Problem.FUNCTION_GONE, callback.name(), gone);
    }
    long started = statistics.begin();
    try {
      return whole == null
          ? threaded(caller, site, self, arguments)
          : direct(whole, caller, site, self, arguments);
    } finally {
      statistics.end(started);
    }
  }

  private UrbiObject direct(
      MethodHandle whole, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    Frame outer = context.crossing().leave(caller, self, callback.name());
    UrbiObject result;
    try {
      result = (UrbiObject) whole.invokeExact(arguments);
    } catch (Throwable e) {
      throw JavaFailures.inFunction(context, caller, site, callback.name(), arguments, e);
    } finally {
      context.crossing().back(caller, outer);
    }
    return result;
  }

  private UrbiObject threaded(
      Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments) {
    try {
      Object[] converted = converted(caller, self, arguments);
      return context.converters().result(ThreadedCall.await(context, caller, callback, converted));
    } catch (Throwable e) {
      throw JavaFailures.inFunction(context, caller, site, callback.name(), arguments, e);
    }
  }

  private Object[] converted(Frame caller, UrbiObject self, UrbiObject[] arguments)
      throws Throwable {
    Frame outer = context.crossing().leave(caller, self, callback.name());
    try {
      return context.converters().arguments(callback, arguments);
    } finally {
      context.crossing().back(caller, outer);
    }
  }
}
