package org.urbi.kernel.library.collection;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.value.Comparison;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.Tuples;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiTuple;

/** Tuples (manual, "Tuple"). */
@UrbiType(value = "Tuple", doc = "A fixed number of objects.", needs = Permission.NOTHING)
final class TupleType {
  private TupleType() {}

  @Builtin(doc = "Makes the elements of a list the members.", needs = Permission.CHANGE)
  static UrbiObject init(UrbiTuple self, UrbiList members) {
    self.setElements(members.elements());
    return self;
  }

  /** The members of the target, which need not be a plain tuple. */
  private static List<UrbiObject> members(Frame caller, CallSite site, UrbiObject self) {
    List<UrbiObject> members = Tuples.members(caller, self);
    return members == null
        ? Arguments.<UrbiTuple>unexpected(caller, site, 0, self, "Tuple").elements()
        : members;
  }

  @Builtin(doc = "The members, as asPrintable shows them.")
  static String asString(Frame caller, UrbiObject self) {
    return Printing.container(caller, self);
  }

  @Builtin(
      value = {"members", "asList"},
      doc = "The list of the members.")
  static List<UrbiObject> members(UrbiTuple self) {
    return self.elements();
  }

  @Builtin(doc = "The number of members.")
  static int size(Frame caller, CallSite site, UrbiObject self) {
    return members(caller, site, self).size();
  }

  @Builtin(doc = "A Hash, equal for equal tuples.")
  static UrbiHash hash(Frame caller, CallSite site, UrbiObject self) {
    long code = Hashing.code(caller, members(caller, site, self));
    return Hashing.hash(caller, UrbiHash.mix(4, code));
  }

  @Builtin(value = "[]", doc = "The member at an index.")
  static UrbiObject get(Frame caller, CallSite site, UrbiObject self, UrbiFloat index) {
    List<UrbiObject> members = members(caller, site, self);
    return members.get(Counting.index(caller, site, index, members.size()));
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the member at an index; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject set(
      Frame caller, CallSite site, UrbiTuple self, UrbiFloat index, UrbiObject value) {
    self.set(Counting.index(caller, site, index, self.size()), value);
    return value;
  }

  @Builtin(value = "==", doc = "Whether other is a tuple with equal members.")
  static boolean equals(Frame caller, CallSite site, UrbiObject self, UrbiObject other) {
    if (self == other) {
      return true;
    }
    List<UrbiObject> others = Tuples.members(caller, other);
    return others != null && Comparison.equal(caller, members(caller, site, self), others);
  }

  @Builtin(value = "<", doc = "Whether it comes before another tuple in lexicographic order.")
  static boolean less(Frame caller, CallSite site, UrbiObject self, UrbiObject other) {
    return Comparison.less(caller, members(caller, site, self), argument(caller, site, other));
  }

  /** The members of the argument. */
  private static List<UrbiObject> argument(Frame caller, CallSite site, UrbiObject other) {
    List<UrbiObject> members = Tuples.members(caller, other);
    return members == null
        ? Arguments.<UrbiTuple>unexpected(caller, site, 1, other, "Tuple").elements()
        : members;
  }

  @Builtin(value = "*", doc = "The tuple of the members, each multiplied by a value.")
  static UrbiObject multiply(Frame caller, CallSite site, UrbiObject self, UrbiObject value) {
    List<UrbiObject> products = new ArrayList<>();
    for (UrbiObject member : List.copyOf(members(caller, site, self))) {
      products.add(caller.interpreter().send(caller, member, "*", value));
    }
    return caller.interpreter().world().values().tuple(products);
  }

  @Builtin(value = "+", doc = "The tuple of the sums of the members of both, two by two.")
  static UrbiObject plus(Frame caller, CallSite site, UrbiObject self, UrbiObject other) {
    List<UrbiObject> members = List.copyOf(members(caller, site, self));
    List<UrbiObject> terms = List.copyOf(argument(caller, site, other));
    if (members.size() != terms.size()) {
      throw caller.error(site, Problem.TUPLES_OF_SIZES);
    }
    List<UrbiObject> sums = new ArrayList<>();
    for (UrbiObject member : members) {
      sums.add(caller.interpreter().send(caller, member, "+", terms.get(sums.size())));
    }
    return caller.interpreter().world().values().tuple(sums);
  }

  @Builtin(doc = "Whether the members match those of a pattern, by the match of handler.")
  static boolean matchAgainst(
      Frame caller, CallSite site, UrbiObject self, UrbiObject handler, UrbiObject pattern) {
    List<UrbiObject> patterns = Tuples.members(caller, pattern);
    return patterns != null
        && ListSearch.matchAll(caller, members(caller, site, self), handler, patterns);
  }
}
