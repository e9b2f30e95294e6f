package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** A lexical scope while it is compiled. */
final class Block {
  private final @Nullable Block parent;
  private final Unit unit;
  private final int region;
  private final boolean slots;
  private final boolean scope;
  private final boolean parameters;
  private boolean redefines;
  private boolean tagged;
  private final Map<String, Variable> variables = new LinkedHashMap<>();
  private @Nullable Map<Object, Variable> begun;
  private @Nullable List<Import> imports;

  private Block(@Nullable Block parent, Unit unit, int region, boolean slots, boolean scope) {
    this.parent = parent;
    this.unit = unit;
    this.region = region;
    this.slots = slots;
    this.scope = scope;
    this.parameters = parent == null || parent.unit != unit;
  }

  /** The top level, where {@code var} makes slots of the lobby. */
  static Block top(Unit unit) {
    return new Block(null, unit, 0, true, false);
  }

  /** {@code {…}}. */
  Block scope() {
    return new Block(this, unit, region, false, true);
  }

  /** A construct with variables of its own, such as {@code for}. */
  Block construct() {
    return new Block(this, unit, region, false, false);
  }

  /** The body of {@code do} or {@code class}: {@code var} makes slots of the target. */
  Block target() {
    return new Block(this, unit, region, true, true);
  }

  /** Code that another job executes. */
  Block job(int otherRegion) {
    return new Block(this, unit, otherRegion, false, false);
  }

  /** A part of a job's code that declares where the code around does. */
  Block jobOf(int otherRegion) {
    return new Block(this, unit, otherRegion, slots, false);
  }

  /** The body of a function. */
  Block function(Unit other, int otherRegion) {
    return new Block(this, other, otherRegion, false, true);
  }

  Unit unit() {
    return unit;
  }

  int region() {
    return region;
  }

  /** Whether {@code var x} makes a slot here. */
  boolean declaresSlots() {
    return slots;
  }

  /** The scope around; null at the top level. */
  @Nullable Block nearestScope() {
    Block block = this;
    while (block != null && !block.scope) {
      block = block.parent;
    }
    return block;
  }

  /** The parameters of the function around that has a call message; null at the top level. */
  @Nullable Block nearestFunction() {
    Block block = this;
    while (block != null && !(block.parameters && block.unit.callKey != null)) {
      block = block.parent;
    }
    return block;
  }

  /** Code of this scope may ask for {@code redefinitionMode} or {@code nonInterruptible}. */
  void setRedefines() {
    redefines = true;
  }

  boolean redefines() {
    return redefines;
  }

  /** Code of this scope may ask for a tag that is stopped when the scope is left. */
  void setTagged() {
    tagged = true;
  }

  boolean isTagged() {
    return tagged;
  }

  void add(String name, Variable variable) {
    variables.put(name, variable);
  }

  /**
   * An {@code import} in a scope.
   *
   * @param variable where the object is that names are imported from
   * @param only the only name that is imported, or null
   */
  record Import(Variable variable, @Nullable String only) {
    boolean brings(String name) {
      return only == null || only.equals(name);
    }
  }

  /** Names are looked up in an object, too. */
  void addImport(Import one) {
    if (imports == null) {
      imports = new ArrayList<>();
    }
    imports.addFirst(one);
  }

  /** The imports of this block, the last one first. */
  List<Import> imports() {
    return imports == null ? List.of() : imports;
  }

  @Nullable Block parent() {
    return parent;
  }

  /** Whether {@code this} may be another object than in the block around. */
  boolean changesTarget() {
    return parameters || (slots && scope);
  }

  /** A declaration of this block whose variable another block has begun. */
  void addBegun(Object key, Variable variable) {
    if (begun == null) {
      begun = new IdentityHashMap<>();
    }
    begun.put(key, variable);
  }

  /** The variable of a declaration, if it has been begun elsewhere; or null. */
  @Nullable Variable begun(Object key) {
    for (Block block = this; block != null; block = block.parent) {
      if (block.begun != null && block.begun.containsKey(key)) {
        return block.begun.get(key);
      }
    }
    return null;
  }

  @Nullable Variable local(String name) {
    return variables.get(name);
  }

  /** The variable of that name that is visible here, or null. */
  @Nullable Variable find(String name) {
    for (Block block = this; block != null; block = block.parent) {
      Variable variable = block.variables.get(name);
      if (variable != null) {
        return variable;
      }
    }
    return null;
  }
}
