package org.urbi.ros.uobject;

import java.util.Set;
import java.util.TreeSet;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.urbi.ros.graph.GraphSnapshot;
import org.urbi.ros.graph.Node;

/**
 * What has appeared in the graph and what has vanished, since somebody began to look. What is told
 * is compared with what is there now, not with what was at the time of a change: of changes that
 * come together, or out of order, only the outcome counts.
 */
final class GraphChanges {
  /** Kinds of things of which there are names. */
  enum Kind {
    NODE,
    TOPIC,
    SERVICE
  }

  /** Who is told; by threads of the network, one at a time. */
  interface Listener {
    void changed(Kind kind, String name, boolean appeared);
  }

  private final Node node;
  private final Listener listener;
  private @Nullable GraphSnapshot seen;
  private boolean looking;
  private boolean again;

  private GraphChanges(Node node, Listener listener) {
    this.node = node;
    this.listener = listener;
  }

  /** Begins; what is there already is not told. */
  static void tell(Node node, Listener listener) {
    GraphChanges changes = new GraphChanges(node, listener);
    node.watch(graph -> changes.look());
    changes.look();
  }

  private void look() {
    synchronized (this) {
      again = looking;
      if (looking) {
        return;
      }
      looking = true;
    }
    node.graph()
        .whenComplete((graph, failure) -> {
          try {
            // A master that is away tells nothing: that is no change.
            if (graph != null) {
              compare(graph.visible());
            }
          } finally {
            looked();
          }
        });
  }

  private void looked() {
    boolean more;
    synchronized (this) {
      looking = false;
      more = again;
    }
    if (more) {
      look();
    }
  }

  private void compare(GraphSnapshot now) {
    GraphSnapshot before = seen;
    seen = now;
    if (before != null) {
      compare(Kind.NODE, before.nodes().keySet(), now.nodes().keySet());
      compare(Kind.TOPIC, before.topics().keySet(), now.topics().keySet());
      compare(Kind.SERVICE, before.services().keySet(), now.services().keySet());
    }
  }

  private void compare(Kind kind, Set<String> before, Set<String> now) {
    BiConsumer<Set<String>, Boolean> all =
        (names, appeared) -> names.forEach(name -> listener.changed(kind, name, appeared));
    all.accept(without(before, now), false);
    all.accept(without(now, before), true);
  }

  private static Set<String> without(Set<String> these, Set<String> those) {
    Set<String> rest = new TreeSet<>(these);
    rest.removeAll(those);
    return rest;
  }
}
