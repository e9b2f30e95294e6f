package org.urbi.kernel.compile;

import java.util.ArrayList;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.lang.ast.Declaring;

/** A lexical scope during compilation. */
final class LexicalScope {
  private final @Nullable LexicalScope parent;
  private final CompilationUnit unit;
  private final int region;
  private final boolean slots;
  private final boolean scope;
  private final boolean parameters;
  private boolean calls;
  private final Map<String, LocalVariable> variables = new LinkedHashMap<>();
  private @Nullable Map<Declaring, LocalVariable> begun;
  private @Nullable List<Import> imports;

  private LexicalScope(
      @Nullable LexicalScope parent,
      CompilationUnit unit,
      int region,
      boolean slots,
      boolean scope) {
    this.parent = parent;
    this.unit = unit;
    this.region = region;
    this.slots = slots;
    this.scope = scope;
    this.parameters = parent == null || parent.unit != unit;
  }

  /** The top level, where {@code var} makes slots of the lobby. */
  static LexicalScope top(CompilationUnit unit) {
    return new LexicalScope(null, unit, 0, true, false);
  }

  /** {@code {…}}. */
  LexicalScope scope() {
    return new LexicalScope(this, unit, region, false, true);
  }

  /** A construct with variables of its own, such as {@code for}. */
  LexicalScope construct() {
    return new LexicalScope(this, unit, region, false, false);
  }

  /** The body of {@code do} or {@code class}: {@code var} makes slots of the target. */
  LexicalScope target() {
    return new LexicalScope(this, unit, region, true, true);
  }

  /** Code that another job executes. */
  LexicalScope job(int otherRegion) {
    return new LexicalScope(this, unit, otherRegion, false, false);
  }

  /** A part of a job's code that declares its variables in the surrounding scope. */
  LexicalScope jobOf(int otherRegion) {
    return new LexicalScope(this, unit, otherRegion, slots, false);
  }

  /** The body of a function. */
  LexicalScope function(CompilationUnit other, int otherRegion) {
    return new LexicalScope(this, other, otherRegion, false, true);
  }

  CompilationUnit unit() {
    return unit;
  }

  int region() {
    return region;
  }

  /** Whether {@code var x} makes a slot here. */
  boolean declaresSlots() {
    return slots;
  }

  /** The closest surrounding scope; null at the top level. */
  @Nullable LexicalScope nearestScope() {
    LexicalScope block = this;
    while (block != null && !block.scope) {
      block = block.parent;
    }
    return block;
  }

  /**
   * The parameters of the closest surrounding function that has a call message; null at the top
   * level.
   */
  @Nullable LexicalScope nearestFunction() {
    LexicalScope block = this;
    while (block != null && !(block.parameters && block.unit.callKey != null)) {
      block = block.parent;
    }
    return block;
  }

  /** Code of this block may call a function, which may add something to the end of the scope. */
  void addCall() {
    LexicalScope scope = nearestScope();
    if (scope != null) {
      scope.calls = true;
    }
  }

  /** Whether code of this scope may call functions. */
  boolean calls() {
    return calls;
  }

  void add(String name, LocalVariable variable) {
    variables.put(name, variable);
  }

  /**
   * An {@code import} in a scope.
   *
   * @param variable holds the object from which names are imported
   * @param only the only name that is imported; null for all
   */
  record Import(LocalVariable variable, @Nullable String only) {
    boolean brings(String name) {
      return only == null || only.equals(name);
    }
  }

  /** Adds an object in which names are looked up. */
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

  @Nullable LexicalScope parent() {
    return parent;
  }

  /** Whether {@code this} may be another object than in the surrounding block. */
  boolean changesTarget() {
    return parameters || (slots && scope);
  }

  /** Notes that another block has already created the variable of a declaration of this block. */
  void addBegun(Declaring key, LocalVariable variable) {
    if (begun == null) {
      begun = new IdentityHashMap<>();
    }
    begun.put(key, variable);
  }

  /** The variable of a declaration, if another block has created it; or null. */
  @Nullable LocalVariable begun(Declaring key) {
    for (LexicalScope block = this; block != null; block = block.parent) {
      if (block.begun != null && block.begun.containsKey(key)) {
        return block.begun.get(key);
      }
    }
    return null;
  }

  /** The variables of this block. */
  Collection<LocalVariable> variables() {
    return variables.values();
  }

  @Nullable LocalVariable local(String name) {
    return variables.get(name);
  }

  /** The variable of that name that is visible here, or null. */
  @Nullable LocalVariable find(String name) {
    for (LexicalScope block = this; block != null; block = block.parent) {
      LocalVariable variable = block.variables.get(name);
      if (variable != null) {
        return variable;
      }
    }
    return null;
  }
}
