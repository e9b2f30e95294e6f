package org.urbi.kernel.observe;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.job.TagScope;
import org.urbi.kernel.job.TagState;
import org.urbi.kernel.object.UrbiObject;
import org.urbi.kernel.object.UrbiString;
import org.urbi.kernel.object.Utf8Text;

/** The tags that somebody has been told of. On the kernel thread. */
final class SeenTags {
  private static final class Seen {
    private final TagState state;
    private TagRow told;

    Seen(TagState state, TagRow told) {
      this.state = state;
      this.told = told;
    }
  }

  private final Map<Long, Seen> all = new LinkedHashMap<>();
  private final List<TagRow> fresh = new ArrayList<>();

  /** The numbers of the tags of a scope that code can name, outermost first. */
  List<Long> of(TagScope scope) {
    List<Long> numbers = new ArrayList<>();
    for (TagState tag : scope.tags()) {
      String name = name(tag);
      if (name != null) {
        numbers.addFirst(tag.number());
        if (!all.containsKey(tag.number())) {
          TagRow row = row(tag, name);
          all.put(tag.number(), new Seen(tag, row));
          fresh.add(row);
        }
      }
    }
    return numbers;
  }

  /** The tags that are new or have changed, since this was last asked. */
  List<TagRow> changes(boolean all) {
    List<TagRow> changes = new ArrayList<>(fresh);
    fresh.clear();
    if (all) {
      for (Seen tag : this.all.values()) {
        if (tag.told.frozen() != tag.state.isFrozen()
            || tag.told.blocked() != tag.state.isBlocked()) {
          tag.told = row(tag.state, tag.told.name());
          changes.add(tag.told);
        }
      }
    }
    return changes;
  }

  /** Forgets the tags under which there is nothing any more, and which stop nothing from coming. */
  List<Long> gone() {
    List<Long> gone = new ArrayList<>();
    for (Iterator<Seen> each = all.values().iterator(); each.hasNext(); ) {
      TagState tag = each.next().state;
      if (!tag.isUsed() && !tag.isFrozen() && !tag.isBlocked()) {
        gone.add(tag.number());
        each.remove();
      }
    }
    return gone;
  }

  private static TagRow row(TagState tag, String name) {
    return new TagRow(tag.number(), name, tag.isFrozen(), tag.isBlocked());
  }

  /** The name of a tag; null for those of constructs of the language. */
  private static @Nullable String name(TagState tag) {
    UrbiObject owner = tag.owner();
    if (owner == null) {
      return null;
    }
    UrbiObject name = owner.lookup(owner.world().symbol("name"));
    return name instanceof UrbiString text ? Utf8Text.toJava(text.value()) : null;
  }
}
