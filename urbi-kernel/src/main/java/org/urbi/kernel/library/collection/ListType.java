package org.urbi.kernel.library.collection;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Optional;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.library.lobby.Warnings;
import org.urbi.kernel.library.text.StringType;
import org.urbi.kernel.library.value.Comparison;
import org.urbi.kernel.library.value.Counting;
import org.urbi.kernel.library.value.Hashing;
import org.urbi.kernel.library.value.Printing;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.Elements;
import org.urbi.kernel.object.UrbiFloat;
import org.urbi.kernel.object.UrbiHash;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.Values;

/** Lists (manual, "List"): their elements, and what changes them. */
@UrbiType(
    value = "List",
    protos = {"Container", "RangeIterable", "Orderable"},
    doc = "An ordered sequence of any objects.",
    needs = Permission.NOTHING)
final class ListType {
  /** How many elements are copied between two looks whether the job is to end. */
  private static final int PIECE = 1 << 16;

  private ListType() {}

  private static Values values(Frame caller) {
    return caller.interpreter().world().values();
  }

  // ------------------------------------------------------------------ what it is

  @Builtin(doc = "Whether it is not empty.")
  static boolean asBool(UrbiList self) {
    return !self.elements().isEmpty();
  }

  @Builtin(doc = "The target.")
  static UrbiObject asList(UrbiList self) {
    return self;
  }

  @Builtin(doc = "The elements, as asPrintable shows them.")
  static String asString(Frame caller, UrbiList self) {
    return Printing.container(caller, self);
  }

  @Builtin(doc = "Whether it has no elements.")
  static boolean empty(UrbiList self) {
    return self.elements().isEmpty();
  }

  @Builtin(doc = "The number of elements.")
  static int size(UrbiList self) {
    return self.elements().size();
  }

  @Builtin(doc = "A Hash, equal for equal lists.")
  static UrbiHash hash(Frame caller, UrbiList self) {
    return Hashing.hash(caller, Hashing.code(caller, self.elements()));
  }

  @Builtin(doc = "The list of valid indexes.")
  static List<UrbiObject> keys(Frame caller, UrbiList self) {
    List<UrbiObject> keys = new ArrayList<>();
    for (int i = 0; i < self.elements().size(); i++) {
      caller.job().worked(1);
      keys.add(values(caller).number(i));
    }
    return keys;
  }

  // ------------------------------------------------------------------ elements

  @Builtin(value = "[]", doc = "The element at an index; negative ones count from the end.")
  static UrbiObject get(Frame caller, CallSite site, UrbiList self, UrbiFloat index) {
    List<UrbiObject> elements = self.elements();
    return elements.get(Counting.index(caller, site, index, elements.size()));
  }

  @Builtin(
      value = "[]=",
      doc = "Replaces the element at an index; returns the value.",
      needs = Permission.CHANGE)
  static UrbiObject set(
      Frame caller, CallSite site, UrbiList self, UrbiFloat index, UrbiObject value) {
    Elements elements = self.modify();
    elements.set(Counting.index(caller, site, index, elements.size()), value);
    self.noteContentChange();
    return value;
  }

  @Builtin(
      value = {"front", "head"},
      doc = "The first element.")
  static UrbiObject front(Frame caller, CallSite site, UrbiList self) {
    return notEmpty(caller, site, self).getFirst();
  }

  @Builtin(doc = "The last element.")
  static UrbiObject back(Frame caller, CallSite site, UrbiList self) {
    return notEmpty(caller, site, self).getLast();
  }

  @Builtin(doc = "All elements but the first one.")
  static UrbiList tail(Frame caller, CallSite site, UrbiList self) {
    List<UrbiObject> elements = notEmpty(caller, site, self);
    Elements tail = new Elements(elements.size() - 1);
    copy(caller, elements, 1, tail);
    return values(caller).listOf(tail);
  }

  private static List<UrbiObject> notEmpty(Frame caller, CallSite site, UrbiList self) {
    List<UrbiObject> elements = self.elements();
    if (elements.isEmpty()) {
      throw caller.error(site, Problem.EMPTY_LIST);
    }
    return elements;
  }

  @Builtin(
      doc = "The elements from begin to end, which is excluded; negatives number from the end.")
  static List<UrbiObject> range(
      Frame caller,
      CallSite site,
      UrbiList self,
      UrbiFloat begin,
      @Optional @Nullable UrbiObject end) {
    int from = 0;
    int to = Counting.index(caller, site, begin);
    if (end != null && end != values(caller).nil) {
      from = to;
      to =
          end instanceof UrbiFloat number
              ? Counting.index(caller, site, number)
              : Arguments.<Integer>unexpected(caller, site, 2, end, "Float");
    }
    List<UrbiObject> elements = self.elements();
    int size = elements.size();
    for (int bound : new int[] {from, to}) {
      if (bound > size || bound < -size) {
        throw Counting.invalidIndex(caller, site, bound);
      }
    }
    List<UrbiObject> range = new ArrayList<>();
    for (int i = from; i < to; i++) {
      caller.job().worked(1);
      range.add(elements.get(i < 0 ? i + size : i));
    }
    return range;
  }

  // ------------------------------------------------------------------ changes

  @Builtin(doc = "Removes all elements.", needs = Permission.CHANGE)
  static UrbiObject clear(UrbiList self) {
    self.modify().clear();
    return changed(self);
  }

  private static UrbiObject changed(UrbiList self) {
    self.noteContentChange();
    return self;
  }

  @Builtin(
      doc = "Inserts an element before the one at an index; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject insert(
      Frame caller, CallSite site, UrbiList self, UrbiFloat where, UrbiObject what) {
    Elements elements = self.modify();
    int index = Counting.index(caller, site, where);
    if (index < 0 || index >= elements.size()) {
      throw Counting.invalidIndex(caller, site, index);
    }
    elements.add(index, what);
    return changed(self);
  }

  @Builtin(
      value = {"insertBack", "<<"},
      doc = "Adds an element at the end; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject insertBack(UrbiList self, UrbiObject that) {
    self.modify().add(that);
    return changed(self);
  }

  @Builtin(doc = "Adds an element at the beginning; returns the target.", needs = Permission.CHANGE)
  static UrbiObject insertFront(UrbiList self, UrbiObject that) {
    self.modify().add(0, that);
    return changed(self);
  }

  @Builtin(
      doc = "Adds an element at the end, unless the list has it; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject insertUnique(Frame caller, UrbiList self, UrbiObject that) {
    return ListSearch.has(caller, self, that) ? self : insertBack(self, that);
  }

  @Builtin(
      value = "+=",
      doc = "Adds the elements of a list at the end; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject addAll(Frame caller, UrbiList self, UrbiList that) {
    caller.job().worked(that.elements().size());
    Counting.checkMemoryOfList(caller, that.elements().size());
    self.modify().addAll(that.elements());
    return changed(self);
  }

  @Builtin(doc = "Deprecated: use '+='.", needs = Permission.CHANGE)
  static UrbiObject append(Frame caller, CallSite site, UrbiList self, UrbiList that) {
    Warnings.deprecated(caller, site, "list.append(that)", "list += that");
    return addAll(caller, self, that);
  }

  @Builtin(
      doc = "Removes all elements equal to a value; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject remove(Frame caller, UrbiList self, UrbiObject val) {
    for (UrbiObject element : List.copyOf(self.elements())) {
      if (Comparison.equal(caller, element, val)) {
        removeSame(caller, self, element);
      }
    }
    return self;
  }

  private static void removeSame(Frame caller, UrbiList self, UrbiObject element) {
    caller.job().worked(self.elements().size());
    if (self.modify().removeIf(e -> e == element)) {
      self.noteContentChange();
    }
  }

  @Builtin(
      doc = "Removes all elements that are the very object; returns the target.",
      needs = Permission.CHANGE)
  static UrbiObject removeById(Frame caller, UrbiList self, UrbiObject that) {
    removeSame(caller, self, that);
    return self;
  }

  @Builtin(doc = "Removes and returns the last element.", needs = Permission.CHANGE)
  static UrbiObject removeBack(Frame caller, CallSite site, UrbiList self) {
    notEmpty(caller, site, self);
    UrbiObject removed = self.modify().removeLast();
    self.noteContentChange();
    return removed;
  }

  @Builtin(doc = "Removes and returns the first element.", needs = Permission.CHANGE)
  static UrbiObject removeFront(Frame caller, CallSite site, UrbiList self) {
    notEmpty(caller, site, self);
    UrbiObject removed = self.modify().removeFirst();
    self.noteContentChange();
    return removed;
  }

  // ------------------------------------------------------------------ new lists

  @Builtin(value = "+", doc = "The elements of the target, then those of another list.")
  static UrbiList plus(Frame caller, UrbiList self, UrbiList other) {
    Counting.checkMemoryOfList(caller, (long) self.elements().size() + other.elements().size());
    Elements sum = new Elements(self.elements().size() + other.elements().size());
    copy(caller, self.elements(), 0, sum);
    copy(caller, other.elements(), 0, sum);
    return values(caller).listOf(sum);
  }

  /** Adds elements from that index on to others, looking now and then whether the job is to end. */
  private static void copy(Frame caller, List<UrbiObject> from, int begin, Elements to) {
    int all = from.size();
    for (int done = begin; done < all; done += PIECE) {
      int end = Math.min(done + PIECE, all);
      caller.job().worked(end - done);
      to.addRange(from, done, end);
    }
  }

  @Builtin(value = "-", doc = "The elements that are equal to none of another list.")
  static List<UrbiObject> minus(Frame caller, UrbiList self, UrbiList other) {
    List<UrbiObject> rest = new ArrayList<>();
    for (UrbiObject element : List.copyOf(self.elements())) {
      if (!ListSearch.has(caller, other, element)) {
        rest.add(element);
      }
    }
    return rest;
  }

  @Builtin(value = "*", doc = "The elements, so many times.")
  static UrbiList multiply(Frame caller, CallSite site, UrbiList self, UrbiFloat n) {
    List<UrbiObject> elements = self.elements();
    int count = Counting.ofLists(caller, site, 1, n, elements.size());
    int size = elements.size();
    int all = count * size;
    Elements product = new Elements(all);
    if (all > 0) {
      copy(caller, elements, 0, product);
    }
    while (product.size() < all) {
      int done = product.size();
      int begin = done % size;
      int more = Math.min(Math.min(done - begin, all - done), PIECE);
      caller.job().worked(more);
      product.addRange(product, begin, begin + more);
    }
    return values(caller).listOf(product);
  }

  @Builtin(doc = "The elements, last one first.")
  static UrbiList reverse(Frame caller, UrbiList self) {
    List<UrbiObject> elements = self.elements();
    Elements reversed = new Elements(elements.size());
    for (int i = elements.size() - 1; i >= 0; i--) {
      caller.job().worked(1);
      reversed.add(elements.get(i));
    }
    return values(caller).listOf(reversed);
  }

  @Builtin(
      doc = "Their asString one after the other, with sep between them, within prefix, suffix.")
  static String join(
      Frame caller,
      UrbiList self,
      @Optional @Nullable String sep,
      @Optional @Nullable String prefix,
      @Optional @Nullable String suffix) {
    return StringType.join(
        caller,
        sep == null ? "" : sep,
        self.elements(),
        prefix == null ? "" : prefix,
        suffix == null ? "" : suffix);
  }
}
