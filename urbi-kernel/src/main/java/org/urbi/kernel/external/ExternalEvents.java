package org.urbi.kernel.external;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.urbi.kernel.event.Emission;
import org.urbi.kernel.event.Subscription;
import org.urbi.kernel.job.Job;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.uobject.ObjectAccess;

/** The events to which an external process has subscribed. */
public final class ExternalEvents {
  private static final int EMIT = 2;
  private static final int END = 3;

  /** Sends the process the emissions that have a given number of arguments. */
  private record Listener(ExternalProcess process, ObjectAccess access, String name, int arity)
      implements Subscription {
    @Override
    public void begin(Emission emission, Job emitter) {
      tell(EMIT, emission);
    }

    @Override
    public void end(Emission emission, Job emitter) {
      tell(END, emission);
    }

    private void tell(int code, Emission emission) {
      if (emission.payload().length == arity) {
        StringBuilder text = process.message(code, name);
        for (UrbiObject argument : emission.payload()) {
          ValueText.append(text.append(", "), access.toJava(name, argument));
        }
        process.send(text);
      }
    }
  }

  private final ExternalProcess process;
  private final ObjectAccess access;
  private final Map<String, Runnable> ends = new HashMap<>();

  ExternalEvents(ExternalProcess process, ObjectAccess access) {
    this.process = process;
    this.access = access;
  }

  /**
   * {@code external event}: the process has a function for emissions with that number of arguments.
   *
   * @throws IllegalArgumentException if there is no such object, or it is no event
   */
  public void listen(Frame frame, int arity, String name) {
    String full = name + "__" + arity;
    if (!ends.containsKey(full) && !process.isRefused(name)) {
      ends.put(full, access.listen(frame, name, new Listener(process, access, full, arity)));
    }
  }

  /** Forgets the events of an object that no longer exists. */
  void forget(String object) {
    List.copyOf(ends.keySet()).stream()
        .filter(name -> name.startsWith(object + "."))
        .forEach(name -> ends.remove(name).run());
  }

  void clear() {
    ends.values().forEach(Runnable::run);
    ends.clear();
  }
}
