package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiBinary;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * Finds objects and slots by the way to them: lines of text, the first of which is the name of a
 * lobby, or {@code Global}; each other one leads from an object to the next one, {@code .x} to the
 * value of its own slot x, {@code :0} to its first prototype. No function of urbiscript is called.
 * On the kernel thread.
 */
public final class Places {
  private static final String GLOBAL = "Global";

  /** A slot of an object of its own. */
  record Slot(UrbiObject holder, Symbol name) {
    /** The value; of a variable with hooks, that which everybody reads. */
    UrbiObject value() {
      UrbiUVar variable = variable();
      return variable == null ? holder.existingSlot(name) : variable.visible().value();
    }

    /** The variable with hooks behind it, or null. */
    @Nullable UrbiUVar variable() {
      return UrbiUVar.behind(holder, name);
    }
  }

  private final UrbiObject global;
  private final Supplier<List<UrbiLobby>> lobbies;

  /**
   * @param global the object Global
   * @param lobbies those of the kernel
   */
  public Places(UrbiObject global, Supplier<List<UrbiLobby>> lobbies) {
    this.global = global;
    this.lobbies = lobbies;
  }

  /** Where ways begin. */
  List<String> roots() {
    return Stream.concat(Stream.of(GLOBAL), lobbies.get().stream().map(UrbiLobby::name)).toList();
  }

  /** The objects where ways begin. */
  List<UrbiObject> rootObjects() {
    List<UrbiObject> all = new ArrayList<>(List.of(global));
    all.addAll(lobbies.get());
    return all;
  }

  /** The object at the end of a way; null if it leads nowhere. */
  @Nullable UrbiObject object(String way) {
    int end = way.indexOf('\n');
    UrbiObject at = root(end < 0 ? way : way.substring(0, end));
    while (end >= 0 && at != null) {
      int begin = end + 1;
      end = way.indexOf('\n', begin);
      at = next(at, way.substring(begin, end < 0 ? way.length() : end));
    }
    return at;
  }

  private @Nullable UrbiObject root(String name) {
    if (name.equals(GLOBAL)) {
      return global;
    }
    for (UrbiLobby lobby : lobbies.get()) {
      if (lobby.name().equals(name)) {
        return lobby;
      }
    }
    return null;
  }

  private static @Nullable UrbiObject next(UrbiObject at, String step) {
    if (step.startsWith(":")) {
      UrbiObject[] protos = at.protos();
      for (int i = 0; i < protos.length; i++) {
        if (step.equals(":" + i)) {
          return protos[i];
        }
      }
      return null;
    }
    Slot slot = slot(at, step);
    UrbiObject value = slot == null ? null : slot.value();
    return value instanceof Code ? null : value;
  }

  /** The slot at the end of a way; null if it leads nowhere. */
  @Nullable Slot slot(String way) {
    int last = way.lastIndexOf('\n');
    UrbiObject holder = last < 0 ? null : object(way.substring(0, last));
    return holder == null ? null : slot(holder, way.substring(last + 1));
  }

  private static @Nullable Slot slot(UrbiObject holder, String step) {
    if (!step.startsWith(".")) {
      return null;
    }
    Symbol name = holder.world().symbol(Utf8Text.toUrbi(step.substring(1)));
    return holder.localSlot(name) == null ? null : new Slot(holder, name);
  }

  /** The values of slots by now. */
  public Sample sample(long now, List<String> ways) {
    List<Double> numbers = new ArrayList<>();
    for (int i = 0; i < ways.size() && i < Sample.MOST; i++) {
      numbers.add(number(ways.get(i)));
    }
    return new Sample(now, numbers);
  }

  private double number(String way) {
    Slot slot = slot(way);
    return slot != null && slot.value() instanceof UrbiFloat number ? number.value() : Double.NaN;
  }

  /** What a slot holds that people can see or hear; null if it is no longer there, or too long. */
  public @Nullable Media media(String way) {
    Slot slot = slot(way);
    return slot != null
            && slot.value() instanceof UrbiBinary binary
            && !Media.kind(binary).isEmpty()
            && binary.data().length() <= Media.LONGEST
        ? new Media(binary.keywords(), binary.data())
        : null;
  }

  /** A way as people write it: {@code Global.robot.speed}. */
  static String shown(String way) {
    return way.lines()
        .map(step -> step.startsWith(":") ? ".protos[" + step.substring(1) + "]" : step)
        .collect(Collectors.joining());
  }
}
