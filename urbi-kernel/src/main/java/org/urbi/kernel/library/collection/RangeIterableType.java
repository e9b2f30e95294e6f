package org.urbi.kernel.library.collection;

import java.util.List;
import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.builtin.Arguments;
import org.urbi.kernel.library.value.Iteration;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiList;
import org.urbi.kernel.object.UrbiObject;

/** Objects with {@code asList} (manual, "RangeIterable"). */
@UrbiType(
    value = "RangeIterable",
    doc = "Objects whose members can be gone through.",
    needs = Permission.NOTHING)
final class RangeIterableType {
  private RangeIterableType() {}

  private static List<UrbiObject> members(Frame caller, CallSite site, UrbiObject self) {
    UrbiObject members = caller.interpreter().send(caller, self, "asList");
    return members instanceof UrbiList list
        ? list.elements()
        : Arguments.<UrbiList>unexpected(caller, site, 0, members, "List").elements();
  }

  @Builtin(doc = "Whether fun is true for all members.")
  static boolean all(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    return Iteration.all(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(doc = "Whether fun is true for a member.")
  static boolean any(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    return Iteration.any(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(doc = "Calls fun with each member, one after the other.")
  static void each(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    Iteration.sequentially(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(value = "each|", doc = "Calls fun with each member, without letting others run.")
  static void eachTight(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    Iteration.tightly(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(value = "each&", doc = "Calls fun with each member, all at once.")
  static void eachConcurrent(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    Iteration.concurrently(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(doc = "The results of fun for each member.")
  static List<UrbiObject> map(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    return Iteration.map(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(doc = "The members for which fun is true.")
  static List<UrbiObject> filter(Frame caller, CallSite site, UrbiObject self, UrbiObject fun) {
    return Iteration.filter(caller, site, self, members(caller, site, self), fun);
  }

  @Builtin(doc = "From value on, the result of action for the result so far and the next member.")
  static UrbiObject foldl(
      Frame caller, CallSite site, UrbiObject self, UrbiObject action, UrbiObject value) {
    return Iteration.foldl(caller, site, self, members(caller, site, self), action, value);
  }
}
