package org.urbi.kernel.node;

import org.urbi.kernel.object.UrbiObject;

/** The method {@code asType} of a type: returns its target. */
final class IdentityCode extends Code {
  IdentityCode(UrbiObject prototype) {
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
