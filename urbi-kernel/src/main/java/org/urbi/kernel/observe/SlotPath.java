package org.urbi.kernel.observe;

import java.util.List;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Interpreter;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Utf8Text;
import org.urbi.kernel.variable.UrbiUVar;

/**
 * A way to a slot over the slots of other objects: {@code robot.body.x}. No function is called on
 * the way.
 *
 * @param starts where it may begin: at the first of them that has the first name itself, or else at
 *     the last one
 * @param text the names, with periods between them
 */
record SlotPath(
    Interpreter interpreter, Supplier<? extends List<? extends UrbiObject>> starts, String text) {
  private static final Predicate<String> IS_NAME =
      Pattern.compile("[A-Za-z_]\\w*").asMatchPredicate();

  /** Whether a text can be a path. */
  static boolean isPath(String text) {
    // Name by name: an expression for the whole would need a stack as deep as the path is long.
    return Stream.of(text.split("\\.", -1)).allMatch(IS_NAME);
  }

  /** The name of the slot itself. */
  String slot() {
    return Utf8Text.toUrbi(text.substring(text.lastIndexOf('.') + 1));
  }

  /** The object that has the slot, or inherits it; null if it is not there. */
  @Nullable UrbiObject owner() {
    String[] names = Utf8Text.toUrbi(text).split("\\.");
    Symbol first = interpreter.world().symbol(names[0]);
    List<? extends UrbiObject> present = starts.get();
    for (UrbiObject start : present) {
      start.noteStructureRead();
      if (start.localSlot(first) != null) {
        return owner(start, names);
      }
    }
    return owner(present.getLast(), names);
  }

  private @Nullable UrbiObject owner(UrbiObject start, String[] names) {
    UrbiObject owner = start;
    for (int i = 0; i < names.length - 1 && owner != null; i++) {
      owner = value(stored(owner, names[i]));
    }
    return owner instanceof Code ? null : owner;
  }

  /** The value of the slot; null if it is not there. */
  @Nullable UrbiObject value() {
    UrbiObject owner = owner();
    return owner == null ? null : value(stored(owner, slot()));
  }

  private static @Nullable UrbiObject value(@Nullable UrbiObject stored) {
    return stored instanceof UrbiUVar variable ? variable.visible().value() : stored;
  }

  private @Nullable UrbiObject stored(UrbiObject owner, String name) {
    return interpreter.findRaw(owner, owner.world().symbol(name));
  }
}
