package org.urbi.kernel.job;

import java.lang.ref.WeakReference;
import org.jspecify.annotations.Nullable;

/**
 * A handler that waits under a scope but is kept alive only by what it watches. When that object is
 * dropped, the handler can never run again, and both are forgotten.
 */
public final class WeakAttachment implements TagScope.Attachment {
  private final WeakReference<TagScope.Attachment> handler;
  private TagScope.@Nullable Attachment kept;

  public WeakAttachment(TagScope.Attachment handler) {
    this.handler = new WeakReference<>(handler);
  }

  /**
   * Sets whether the scope keeps the handler alive, because it has begun something that must end.
   */
  public void keep(boolean on) {
    kept = on ? handler.get() : null;
  }

  @Override
  public TagScope.@Nullable Attachment handler() {
    return handler.get();
  }

  @Override
  public boolean isGone() {
    return handler.refersTo(null);
  }

  @Override
  public void stopped(@Nullable TagScope by) {
    TagScope.Attachment there = handler.get();
    if (there != null) {
      there.stopped(by);
    }
  }
}
