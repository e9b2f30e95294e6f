package org.urbi.kernel.tier;

import java.lang.ref.ReferenceQueue;
import java.lang.ref.WeakReference;
import java.util.HashSet;
import java.util.Set;
import org.urbi.kernel.node.CompiledCode;

/** How many bytes of classes somebody may still use: those of code that is not yet forgotten. */
final class ClassesInUse {
  private static final class Entry extends WeakReference<CompiledCode> {
    final int bytes;

    Entry(CompiledCode compiled, int bytes, ReferenceQueue<CompiledCode> forgotten) {
      super(compiled, forgotten);
      this.bytes = bytes;
    }
  }

  private final long most;
  private final ReferenceQueue<CompiledCode> forgotten = new ReferenceQueue<>();
  private final Set<Entry> entries = new HashSet<>();
  private long bytes;

  /**
   * @param most when there are so many bytes there is no room for more
   */
  ClassesInUse(long most) {
    this.most = most;
  }

  /** A class of that length has been made. */
  void add(CompiledCode compiled, int length) {
    entries.add(new Entry(compiled, length, forgotten));
    bytes += length;
  }

  /** Whether another class may be made. */
  boolean hasRoom() {
    for (var gone = forgotten.poll(); gone != null; gone = forgotten.poll()) {
      if (gone instanceof Entry entry && entries.remove(entry)) {
        bytes -= entry.bytes;
      }
    }
    return bytes < most;
  }
}
