package org.urbi.ros.two;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.rtps.Guid;
import org.urbi.ros.rtps.GuidPrefix;

/**
 * Which node has which writers and readers. Participants tell that apart from what these are, and
 * usually later; those of other makers of DDS never do.
 */
final class Owners {
  /** Seconds in which a participant tells it. */
  private static final int PATIENCE = 2;

  private final Map<Guid, Entities> participants = new ConcurrentHashMap<>();
  private final Map<Guid, CompletableFuture<String>> awaited = new ConcurrentHashMap<>();

  void put(Entities told) {
    participants.put(told.participant(), told);
    for (Guid each : List.copyOf(awaited.keySet())) {
      String owner = find(each);
      CompletableFuture<String> waiting = owner == null ? null : awaited.remove(each);
      if (waiting != null) waiting.complete(owner);
    }
  }

  void forget(GuidPrefix gone) {
    participants.keySet().removeIf(each -> each.prefix().equals(gone));
  }

  Collection<Entities> all() {
    return participants.values();
  }

  private @Nullable String find(Guid endpoint) {
    for (Entities each : participants.values())
      for (Entities.NodeEntities node : each.nodes())
        if (node.readers().contains(endpoint) || node.writers().contains(endpoint))
          return node.fullName();
    return null;
  }

  /** The node that has that writer or reader; its identifier if that was not told. */
  String now(Guid endpoint) {
    String owner = find(endpoint);
    return owner == null ? endpoint.toString() : owner;
  }

  /** The name of the owner as soon as it is told; the identifier if that takes too long. */
  CompletableFuture<String> soon(Guid endpoint) {
    CompletableFuture<String> known =
        awaited.computeIfAbsent(
            endpoint,
            guid ->
                new CompletableFuture<String>()
                    .completeOnTimeout(guid.toString(), PATIENCE, TimeUnit.SECONDS));
    // It may have been told while this was asked.
    String owner = find(endpoint);
    if (owner != null) known.complete(owner);
    known.whenComplete((name, failure) -> awaited.remove(endpoint, known));
    return known;
  }
}
