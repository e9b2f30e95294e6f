package org.urbi.kernel.library.object;

import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** A method turned into a function whose only argument is the target. */
final class BouncedCode extends Code {
  private final String name;

  BouncedCode(World world, String name) {
    super(world.prototype("Code").cloneShape());
    this.name = name;
  }

  @Override
  public boolean isLazy() {
    return false;
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    if (arguments.length != 1) {
      throw caller.interpreter().errors().arity(name, arguments.length, 1, 1);
    }
    return caller.interpreter().send(caller, arguments[0], name);
  }
}
