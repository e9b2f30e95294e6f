package org.urbi.kernel.library.code;

import org.urbi.kernel.node.CallSite;
import org.urbi.kernel.node.Code;
import org.urbi.kernel.node.Frame;
import org.urbi.kernel.object.UrbiObject;

/** The method {@code asType} of a type: returns its target. */
public final class IdentityCode extends Code {
  public IdentityCode(UrbiObject prototype) {
    super(prototype.cloneShape());
  }

  @Override
  public boolean isLazy() {
    return false;
  }

  @Override
  public UrbiObject call(Frame caller, CallSite site, UrbiObject self, UrbiObject... arguments) {
    return self;
  }
}
