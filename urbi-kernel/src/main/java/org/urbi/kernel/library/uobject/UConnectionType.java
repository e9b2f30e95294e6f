package org.urbi.kernel.library.uobject;

import org.urbi.builtins.Builtin;
import org.urbi.builtins.Permission;
import org.urbi.builtins.UrbiType;
import org.urbi.kernel.error.Problem;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;
import org.urbi.kernel.uobject.PluggedContext;
import org.urbi.kernel.variable.UrbiConnection;
import org.urbi.kernel.variable.UrbiUVar;

/** Links between variables (manual, "Customizing data-flow links"). */
@UrbiType(
    value = "UConnection",
    protos = {"Subscription"},
    doc = "Leads each new value of one variable to another.",
    needs = Permission.NOTHING)
final class UConnectionType {
  private final PluggedContext uobjects;

  UConnectionType(PluggedContext uobjects) {
    this.uobjects = uobjects;
  }

  static UrbiObject newPrototype(World world) {
    return new UrbiConnection(world.values().object.cloneShape());
  }

  @Builtin(doc = "Leads the values of a variable to another.", needs = Permission.CHANGE)
  void init(Frame frame, UrbiConnection self, UrbiUVar source, UrbiUVar target) {
    connect(frame, "init", self, source, target);
  }

  private void connect(
      Frame frame, String routine, UrbiConnection self, UrbiUVar source, UrbiUVar target) {
    // Whoever writes the source will write the target.
    UVarType.checkWrite(frame, routine, target);
    self.connect(frame, source, target);
    uobjects.connections().add(self);
  }

  @Builtin(doc = "Ends the link.", needs = Permission.CHANGE)
  void disconnect(Frame frame, UrbiConnection self) {
    self.disconnect();
    uobjects.connections().remove(self);
  }

  @Builtin(doc = "Has the link begin at another variable.", needs = Permission.CHANGE)
  void reconnect(Frame frame, UrbiConnection self, UrbiUVar src) {
    UrbiUVar target = self.target();
    if (target == null) {
      throw frame.interpreter().errors().primitive("reconnect", Problem.LINK_WITHOUT_TARGET);
    }
    connect(frame, "reconnect", self, src, target);
  }

  @Builtin(doc = "Where it begins and ends, to be shown.")
  static String asString(UrbiConnection self) {
    UrbiUVar source = self.source();
    UrbiUVar target = self.target();
    return source == null || target == null
        ? "UConnection"
        : source.name() + " >> " + target.name();
  }
}
