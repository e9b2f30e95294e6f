package org.urbi.kernel.library.object;

import java.util.Arrays;
import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.World;

/** A method turned into a function whose first argument is the target. */
final class MethodFunction extends Code {
  private final String name;

  MethodFunction(World world, String name) {
    super(world.prototype("Code").cloneShape());
    this.name = name;
  }

  @Override
  public boolean isLazy() {
    return false;
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    if (arguments.length == 0) {
      throw caller.interpreter().errors().arity(name, 0, 1, Integer.MAX_VALUE);
    }
    return caller
        .interpreter()
        .send(caller, arguments[0], name, Arrays.copyOfRange(arguments, 1, arguments.length));
  }
}
