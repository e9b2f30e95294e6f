package org.urbi.kernel.uobject;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.error.UrbiException;
import org.urbi.kernel.event.Subscription;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.USlot;
import urbi.UValue;

/**
 * Access to the UObjects of a kernel, their variables and events, for processes that declare
 * UObjects by urbiscript. Used on the kernel thread.
 */
public final class ObjectAccess {
  private final PluggedContext context;

  public ObjectAccess(PluggedContext context) {
    this.context = context;
  }

  /** The UObject of that name; null if there is none. */
  public @Nullable UrbiObject find(String name) {
    return context.objects().find(name);
  }

  /** Tells urbiscript that a UObject is in the process of a client, and in which lobby that is. */
  public void markRemote(String name, UrbiObject lobby) {
    context.objects().markRemote(name, lobby);
  }

  /** Publishes a UObject that is being constructed as a slot of {@code uobjects}. */
  public void show(String name) {
    Instance instance = context.objects().named(name);
    if (instance != null) {
      context.objects().publish(instance);
    }
  }

  /** The name of the UObject from which that one was cloned; null if there is none. */
  public @Nullable String parentOf(String name) {
    UrbiObject object = find(name);
    if (object != null) {
      for (UrbiObject proto : object.protos()) {
        Instance parent = context.objects().nearest(proto);
        if (parent != null) {
          return parent.name();
        }
      }
    }
    return null;
  }

  /**
   * The variable of that name that is there already; null if there is none.
   *
   * @throws IllegalArgumentException if there is no such object
   */
  public @Nullable USlot variable(Frame frame, String name) {
    VariableLookup.Place place = context.variables().place(frame, name);
    UrbiUVar variable = UrbiUVar.behind(place.owner(), place.slot());
    return variable == null ? null : new PluggedSlot(context, frame, variable, name);
  }

  /**
   * Listens to an event.
   *
   * @param name the event as {@code object.slot}
   * @return the action that ends the subscription
   * @throws IllegalArgumentException if there is no such object, or the slot is no event
   */
  public Runnable listen(Frame frame, String name, Subscription listener) {
    context.event(name);
    VariableLookup.Place place = context.variables().place(frame, name);
    if (frame.interpreter().get(frame, place.owner(), place.slot()) instanceof UrbiEvent event) {
      event.subscribe(listener, frame.job());
      return () -> event.unsubscribe(listener);
    }
    throw new KernelRefusal(Problem.NOT_AN_EVENT, name);
  }

  /**
   * Converts a value for a process; void and nil become an empty value.
   *
   * @param routine the function that sends the value
   * @throws UrbiException if it cannot be converted: its text fails, or it contains itself
   */
  public UValue toJava(String routine, UrbiObject value) {
    try {
      return context.conversion().toJava(value);
    } catch (ConversionFailure e) {
      throw context.interpreter().errors().primitive(routine, Problem.NOT_SENDABLE);
    }
  }
}
