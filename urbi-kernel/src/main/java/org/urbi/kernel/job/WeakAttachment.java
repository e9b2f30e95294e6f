package org.urbi.kernel.job;

import java.lang.ref.WeakReference;
import org.jspecify.annotations.Nullable;

/**
 * What waits under a scope for as long as somebody else has it: a handler is kept by what it
 * watches. When that is dropped, nothing can happen to it any more, and both are forgotten.
 */
public final class WeakAttachment implements TagScope.Attachment {
  private final WeakReference<TagScope.Attachment> handler;
  private TagScope.@Nullable Attachment kept;

  public WeakAttachment(TagScope.Attachment handler) {
    this.handler = new WeakReference<>(handler);
  }

  /** Whether the scope is to keep the handler: something has begun that must come to an end. */
  public void keep(boolean on) {
    kept = on ? handler.get() : null;
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
