package org.urbi.kernel.builtin;

import static java.util.Objects.requireNonNull;

import org.jspecify.annotations.Nullable;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.trust.Role;

/**
 * The builtins of one type of the library. The subclasses are generated from the annotations when
 * the project is compiled, so that starting a kernel needs no reflection and no scan.
 */
public abstract class BuiltinTable {
  /**
   * One builtin, as declared.
   *
   * @param max {@link Integer#MAX_VALUE} when there may be any number of arguments
   * @param setter whether it is called when the slot of that name is assigned
   * @param least the least role of the lobby for which it is called
   * @param changes whether the lobby must be allowed to change the target, too
   * @param formals the arguments as the documentation shows them; empty when there are none
   * @param result the type of the result; empty when it may be any
   */
  public record Entry(
      String name,
      int min,
      int max,
      boolean lazy,
      boolean setter,
      Role least,
      boolean changes,
      String formals,
      String result,
      String doc) {}

  private final String type;
  private final String doc;
  private final String @Nullable [] protos;
  private final Entry[] entries;

  protected BuiltinTable(String type, String doc, String @Nullable [] protos, Entry[] entries) {
    this.type = type;
    this.doc = doc;
    this.protos = protos;
    this.entries = entries;
  }

  /** The name of the type in urbiscript, such as "Float" or "Exception.Arity". */
  public final String type() {
    return type;
  }

  /** What the type is, in a sentence; empty in a {@linkplain #isPart part}. */
  public final String doc() {
    return doc;
  }

  /** Whether this table adds builtins to a type that an earlier table declares. */
  public final boolean isPart() {
    return protos == null;
  }

  /** The names of the prototypes, in lookup order; not for a {@linkplain #isPart part}. */
  public final String[] protos() {
    return requireNonNull(protos, "a part has none").clone();
  }

  /**
   * A new object of the Java class that the values of this type have, to become the prototype of
   * the type; null when a plain object will do.
   */
  public @Nullable UrbiObject newPrototype(World world) {
    return null;
  }

  public final int size() {
    return entries.length;
  }

  public final String name(int index) {
    return entries[index].name;
  }

  public final int minArguments(int index) {
    return entries[index].min;
  }

  /** {@link Integer#MAX_VALUE} when there may be any number of arguments. */
  public final int maxArguments(int index) {
    return entries[index].max;
  }

  public final boolean isLazy(int index) {
    return entries[index].lazy;
  }

  /**
   * Whether it is a setter: called when the slot of that name is assigned ({@code
   * SlotData.setSetter}), where another builtin is the value of the slot.
   */
  public final boolean isSetter(int index) {
    return entries[index].setter;
  }

  /** The least role of the lobby for which it is called. */
  public final Role leastRole(int index) {
    return entries[index].least;
  }

  /** Whether the lobby for which it is called must be allowed to change the target. */
  public final boolean changesTarget(int index) {
    return entries[index].changes;
  }

  /** The arguments as the documentation shows them: {@code (to?: Float)}; empty without any. */
  public final String formals(int index) {
    return entries[index].formals;
  }

  /** The type of the result, "void" when there is none; empty when it may be any. */
  public final String result(int index) {
    return entries[index].result;
  }

  /** Its name, its arguments and the type of its result: {@code lock() -> void}. */
  public final String signature(int index) {
    String result = result(index);
    return name(index) + formals(index) + (result.isEmpty() ? "" : " -> " + result);
  }

  public final String doc(int index) {
    return entries[index].doc;
  }

  /** Calls a builtin; the number of arguments has been checked. */
  public abstract UrbiObject call(
      int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments);
}
