package org.urbi.kernel.uobject;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.message.Message;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.variable.UrbiUVar;
import urbi.UClass;
import urbi.UEmitter;
import urbi.UObject;
import urbi.USlot;
import urbi.UValue;

/** What the code of components asks for by a message; done by jobs. */
final class ComponentTasks {
  private final PluggedContext context;
  private final Interpreter interpreter;
  private final boolean replay;

  /** The classes of this process that programs have started, by name. */
  private final Map<String, Class<? extends UObject>> classes = new ConcurrentHashMap<>();

  private int last;

  /** In a replay there are no threads that keep their variables. */
  private final Map<Integer, PluggedSlot> replayed = new HashMap<>();

  ComponentTasks(PluggedContext context) {
    this.context = context;
    this.interpreter = context.interpreter();
    this.replay = interpreter.scheduler().journal().isReplay();
  }

  /** The number of a variable that a component gets; on the kernel thread. */
  int number(PluggedSlot slot) {
    last++;
    if (replay) {
      replayed.put(last, slot);
    }
    return last;
  }

  /** A class that is to be started by its name; from any thread. */
  void offer(Class<? extends UObject> type) {
    classes.put(type.getName(), type);
  }

  /** The variable of a message, in a replay; null if it asks for none. */
  @Nullable PluggedSlot variable(Message.OfComponent asked) {
    return asked instanceof Message.OfVariable of ? replayed.get(of.variable()) : null;
  }

  /**
   * Carries out a request of a thread.
   *
   * @param slot the variable of which it asks, if any
   * @return what the thread gets for it
   * @throws IllegalArgumentException if only the thread has what is to be done
   */
  @Nullable Object run(Frame frame, Message.OfComponent asked, @Nullable PluggedSlot slot) {
    return switch (asked) {
      case Message.OfVariable of when slot != null -> slot.perform(frame, of);
      case Message.ClassStarted started -> context.start(frame, UClass.of(type(started.name())));
      case Message.VariableWanted wanted -> variable(frame, wanted.name(), wanted.input());
      case Message.EventWanted wanted -> event(frame, wanted.name());
      case Message.ObjectWanted wanted ->
          wanted.hub() ? context.hub(wanted.name()) : context.object(wanted.name());
      default -> throw new IllegalArgumentException(asked.toString());
    };
  }

  private Class<? extends UObject> type(String name) {
    Class<? extends UObject> type = classes.get(name);
    if (type != null) {
      return type;
    }
    try {
      return Class.forName(name).asSubclass(UObject.class);
    } catch (ClassNotFoundException | ClassCastException e) {
      throw new IllegalStateException(e);
    }
  }

  /** A variable, as it is used by a component. */
  USlot variable(Frame frame, String name, boolean input) {
    UrbiUVar variable = context.variables().find(frame, name);
    if (input) {
      variable.makeInput();
    }
    return new PluggedSlot(context, frame, variable, name);
  }

  /** An event, which is created if need be. */
  UEmitter event(Frame frame, String name) {
    VariableLookup.Place place = context.variables().place(frame, name);
    if (place.owner().localSlot(place.slot()) == null) {
      place.owner().addSlot(place.slot(), interpreter.prototypes().event.cloned());
    }
    return payload -> context.emit(name, payload);
  }

  /** Emits an event. */
  void emit(Frame frame, String name, UValue... payload) {
    VariableLookup.Place place = context.variables().place(frame, name);
    UrbiObject event = interpreter.get(frame, place.owner(), place.slot());
    UrbiObject[] arguments = objects(payload);
    if (event instanceof UrbiEvent plain) {
      plain.emit(frame, arguments);
    } else {
      interpreter.send(frame, event, "emit", arguments);
    }
  }

  /** Calls a function of urbiscript. */
  void call(Frame frame, Message.ComponentCall wish) {
    UrbiObject target = context.variables().object(frame, wish.object());
    interpreter.send(frame, target, Utf8Text.toUrbi(wish.method()), objects(wish.arguments()));
  }

  private UrbiObject[] objects(UValue[] given) {
    UrbiObject[] made = new UrbiObject[given.length];
    for (int i = 0; i < made.length; i++) {
      made[i] = context.conversion().element(given[i]);
    }
    return made;
  }
}
