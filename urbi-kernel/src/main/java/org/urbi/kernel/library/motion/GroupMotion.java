package org.urbi.kernel.library.motion;

import java.util.ArrayList;
import java.util.List;
import org.urbi.kernel.library.object.UrbiGroup;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.node.ParallelCalls;
import org.urbi.kernel.object.Symbol;
import org.urbi.kernel.object.UrbiDictionary;
import org.urbi.kernel.object.UrbiObject;

/**
 * The motion of a variable of a group: that of each member has a trajectory of its own, all at once
 * (manual, "Gostai Standard Robotics API": {@code robot.wheel.val = … time: 1s}).
 */
final class GroupMotion {
  private GroupMotion() {}

  /**
   * Moves the variables of all members.
   *
   * @param target for all of them, or a group with one for each
   */
  static void run(
      Frame frame,
      CallSite site,
      UrbiObject generator,
      UrbiObject read,
      UrbiObject write,
      UrbiObject target,
      UrbiDictionary attributes) {
    Symbol follow = generator.world().symbol("follow");
    List<UrbiObject> elements = new ArrayList<>();
    int size = group(frame, site, read, generator).members().size();
    for (int i = 0; i < size; i++) {
      elements.add(new Element(read, write, i));
    }
    ParallelCalls.forEach(
        frame,
        elements,
        (forked, value) -> {
          Element element = (Element) value;
          UrbiObject goal =
              target instanceof UrbiGroup goals && goals.members().size() == size
                  ? goals.members().get(element.index)
                  : target;
          forked
              .interpreter()
              .send(forked, site, generator, follow, element, element, goal, attributes);
        });
  }

  private static UrbiGroup group(Frame frame, CallSite site, UrbiObject read, UrbiObject self) {
    return (UrbiGroup) frame.interpreter().call(frame, site, read, self);
  }

  /** One element of a group, as a function that reads it, or writes its argument. */
  private static final class Element extends Code {
    private final UrbiObject read;
    private final UrbiObject write;
    private final int index;

    Element(UrbiObject read, UrbiObject write, int index) {
      super(read.world().prototype("Code").cloneShape());
      this.read = read;
      this.write = write;
      this.index = index;
    }

    @Override
    public boolean isLazy() {
      return false;
    }

    @Override
    public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
      UrbiGroup group = group(caller, site, read, self);
      if (arguments.length == 0) {
        return group.members().get(index);
      }
      List<UrbiObject> values = new ArrayList<>(group.members());
      values.set(index, arguments[0]);
      return caller.interpreter().call(caller, site, write, self, group.sibling(values));
    }
  }
}
