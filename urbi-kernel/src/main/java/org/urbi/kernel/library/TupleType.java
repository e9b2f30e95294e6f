package org.urbi.kernel.library;

import java.util.ArrayList;
import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiTuple;

/** Tuples (manual, "Tuple"). */
@UrbiType(value = "Tuple", doc = "A fixed number of objects.")
final class TupleType {
  private TupleType() {}

  @Builtin(doc = "Makes the elements of a list the members.")
  static UrbiObject init(UrbiTuple self, UrbiList members) {
    self.setElements(members.elements());
    return self;
  }

  @Builtin(doc = "The members, as asPrintable shows them.")
  static String asString(Frame caller, UrbiTuple self) {
    return Printing.container(caller, self);
  }

  @Builtin(
      value = {"members", "asList"},
      doc = "The list of the members.")
  static List<UrbiObject> members(UrbiTuple self) {
    return self.elements();
  }

  @Builtin(doc = "The number of members.")
  static int size(UrbiTuple self) {
    return self.size();
  }

  @Builtin(doc = "A Hash, equal for equal tuples.")
  static UrbiHash hash(Frame caller, UrbiTuple self) {
    return Hashing.hash(caller, UrbiHash.mix(4, Hashing.code(caller, self.elements())));
  }

  @Builtin(value = "[]", doc = "The member at an index.")
  static UrbiObject get(Frame caller, CallSite site, UrbiTuple self, int index) {
    return self.get(Counting.index(caller, site, index, self.size()));
  }

  @Builtin(value = "[]=", doc = "Replaces the member at an index; returns the value.")
  static UrbiObject set(Frame caller, CallSite site, UrbiTuple self, int index, UrbiObject value) {
    self.set(Counting.index(caller, site, index, self.size()), value);
    return value;
  }

  @Builtin(value = "==", doc = "Whether other is a tuple with equal members.")
  static boolean equals(Frame caller, UrbiTuple self, UrbiObject other) {
    return other instanceof UrbiTuple tuple
        && (self == other || Comparison.equal(caller, self.elements(), tuple.elements()));
  }

  @Builtin(value = "<", doc = "Whether it comes before another tuple in lexicographic order.")
  static boolean less(Frame caller, UrbiTuple self, UrbiTuple other) {
    return Comparison.less(caller, self.elements(), other.elements());
  }

  @Builtin(value = "*", doc = "The tuple of the members, each multiplied by a value.")
  static UrbiObject multiply(Frame caller, UrbiTuple self, UrbiObject value) {
    List<UrbiObject> products = new ArrayList<>();
    for (UrbiObject member : self.elements()) {
      products.add(caller.interpreter().send(caller, member, "*", value));
    }
    return caller.interpreter().world().values().tuple(products);
  }

  @Builtin(value = "+", doc = "The tuple of the sums of the members of both, two by two.")
  static UrbiObject plus(Frame caller, CallSite site, UrbiTuple self, UrbiTuple other) {
    if (self.size() != other.size()) {
      throw caller
          .interpreter()
          .errors()
          .primitive(site.calledName(), "tuples must have the same size");
    }
    List<UrbiObject> sums = new ArrayList<>();
    List<UrbiObject> terms = other.elements();
    for (UrbiObject member : self.elements()) {
      sums.add(caller.interpreter().send(caller, member, "+", terms.get(sums.size())));
    }
    return caller.interpreter().world().values().tuple(sums);
  }

  @Builtin(doc = "Whether the members match those of a pattern, by the match of handler.")
  static boolean matchAgainst(
      Frame caller, UrbiTuple self, UrbiObject handler, UrbiObject pattern) {
    return pattern instanceof UrbiTuple other
        && ListSearch.matchAll(caller, self.elements(), handler, other.elements());
  }
}
