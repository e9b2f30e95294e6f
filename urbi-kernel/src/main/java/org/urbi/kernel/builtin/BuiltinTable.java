package org.urbi.kernel.builtin;

import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/**
 * The builtins of one type of the library. The subclasses are generated from the annotations when
 * the project is compiled, so that starting a kernel needs no reflection and no scan.
 */
public abstract class BuiltinTable {
  /** One builtin, as declared. */
  protected record Entry(String name, int min, int max, boolean lazy, String doc) {}

  private final String type;
  private final String doc;
  private final Entry[] entries;

  protected BuiltinTable(String type, String doc, Entry... entries) {
    this.type = type;
    this.doc = doc;
    this.entries = entries;
  }

  /** The name of the type in urbiscript, such as "Float" or "Exception.Arity". */
  public final String type() {
    return type;
  }

  /** What the type is, in a sentence. */
  public final String doc() {
    return doc;
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

  public final String doc(int index) {
    return entries[index].doc;
  }

  /** Calls a builtin; the number of arguments has been checked. */
  public abstract UrbiObject call(
      int index, Frame caller, CallSite site, UrbiObject self, UrbiObject[] arguments);
}
