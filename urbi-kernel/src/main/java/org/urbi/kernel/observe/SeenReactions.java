package org.urbi.kernel.observe;

import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;
import org.urbi.kernel.event.Reaction;
import org.urbi.kernel.event.UrbiEvent;
import org.urbi.kernel.lobby.UrbiLobby;
import org.urbi.lang.source.Span;

/** The reactions and events that somebody has been told of. On the kernel thread. */
final class SeenReactions {
  /** How many of each are shown. */
  private static final int MOST = 500;

  /** How many names of what a condition has read are shown. */
  private static final int MOST_READ = 8;

  /** What never changes of a reaction. */
  private record Lasting(long number, String place, String code) {}

  private final KnownEvents known;
  private final SeenTags tags;
  private final Map<Reaction, Lasting> lasting = new WeakHashMap<>();
  private final SentRows<Long, ReactionRow> rows = new SentRows<>();
  private final SentRows<Long, EventRow> events = new SentRows<>();
  private long last;
  private boolean told;
  private @Nullable Scan scan;

  /** A look at all of them, which has begun. */
  private final class Scan {
    private final String wanted;
    private final List<Reaction> all;
    private final EventSearch search;
    private @Nullable Iterator<Map.Entry<UrbiEvent, String>> found;
    private int next;
    private int total;
    private int eventTotal;

    Scan(String text, Allowance allowance) {
      wanted = text.toLowerCase(Locale.ROOT);
      all = known.reactions();
      allowance.use(all.size());
      search = known.search(all);
    }

    /** Goes on, as far as it is allowed; returns whether it is over. */
    boolean goOn(Allowance allowance) {
      for (; next < all.size() && allowance.isLeft(); next++) {
        look(all.get(next), allowance);
      }
      if (next < all.size() || !search.goOn(allowance)) {
        return false;
      }
      Iterator<Map.Entry<UrbiEvent, String>> left =
          found == null ? search.found().entrySet().iterator() : found;
      found = left;
      while (left.hasNext() && allowance.isLeft()) {
        look(left.next(), allowance);
      }
      return !left.hasNext();
    }

    private void look(Reaction reaction, Allowance allowance) {
      allowance.use(1);
      if ((wanted.isEmpty() || contains(wanted, text(reaction))) && ++total <= MOST) {
        allowance.use(Allowance.ROW);
        ReactionRow row = row(reaction);
        rows.is(row.number(), row);
      }
    }

    private void look(Map.Entry<UrbiEvent, String> each, Allowance allowance) {
      allowance.use(1);
      if (contains(wanted, each.getValue()) && ++eventTotal <= MOST) {
        allowance.use(Allowance.ROW);
        UrbiEvent event = each.getKey();
        events.is(event.number(), row(event, each.getValue()));
      }
    }
  }

  SeenReactions(KnownEvents known, SeenTags tags) {
    this.known = known;
    this.tags = tags;
  }

  /**
   * Looks at them again, as far as it is allowed, or goes on with that.
   *
   * @param text only what contains it is wanted, in whatever case; asked when a look begins
   * @return what has changed; null if not all have been looked at yet
   */
  @Nullable ReactionView look(String text, Allowance allowance) {
    if (!allowance.isLeft()) {
      return null;
    }
    Scan going = scan == null ? new Scan(text, allowance) : scan;
    scan = going;
    if (!going.goOn(allowance)) {
      return null;
    }
    scan = null;
    boolean anew = !told;
    told = true;
    return new ReactionView(
        anew,
        going.total,
        rows.changes(),
        rows.gone(),
        going.eventTotal,
        events.changes(),
        events.gone());
  }

  private static boolean contains(String wanted, String text) {
    return wanted.isEmpty() || text.toLowerCase(Locale.ROOT).contains(wanted);
  }

  private String text(Reaction reaction) {
    return reaction.facts().kind() + " " + lasting(reaction).code();
  }

  private Lasting lasting(Reaction reaction) {
    return lasting.computeIfAbsent(
        reaction,
        unknown -> {
          Span span = reaction.facts().span();
          return new Lasting(++last, Written.place(span), Written.beginning(span));
        });
  }

  private ReactionRow row(Reaction reaction) {
    Reaction.Facts facts = reaction.facts();
    UrbiEvent event = facts.event();
    Lasting known = lasting(reaction);
    return new ReactionRow(
        known.number(),
        facts.kind(),
        facts.lobby() instanceof UrbiLobby lobby ? lobby.name() : "",
        known.place(),
        known.code(),
        facts.scope().isFrozen(),
        tags.of(facts.scope()),
        facts.occurrences().times(),
        facts.occurrences().last(),
        event == null ? 0 : event.number(),
        reaction.read(MOST_READ));
  }

  private static EventRow row(UrbiEvent event, String name) {
    return new EventRow(
        event.number(),
        name,
        event.subscriberCount(),
        event.emissions().times(),
        event.emissions().last());
  }
}
