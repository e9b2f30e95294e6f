package org.urbi.kernel.job;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.Iterator;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * Goes through what is in a tree of scopes, step by step: what is in a scope comes before what is
 * in those within it. What is added to a scope after its turn is left out.
 */
final class ScopeWalk<T> {
  private final Function<TagScope, List<T>> content;
  private final Deque<Iterator<TagScope>> path = new ArrayDeque<>();
  private Iterator<T> items = Collections.emptyIterator();
  private @Nullable T again;

  /**
   * @param content what is in a scope itself, as a list of its own
   */
  ScopeWalk(TagScope top, Function<TagScope, List<T>> content) {
    this.content = content;
    path.push(List.of(top).iterator());
  }

  /**
   * Goes on to the next scope, or calls the action with the next of what is in this one. If there
   * is no memory for that, it is called with the same again.
   *
   * @return false if there was nothing left to do
   */
  boolean step(Consumer<T> action) {
    if (again != null || items.hasNext()) {
      T item = again == null ? items.next() : again;
      again = null;
      try {
        action.accept(item);
      } catch (OutOfMemoryError e) {
        again = item;
        throw e;
      }
      return true;
    }
    Iterator<TagScope> scopes = path.peek();
    if (scopes == null) {
      return false;
    }
    if (scopes.hasNext()) {
      enter(scopes.next());
    } else {
      path.pop();
    }
    return true;
  }

  private void enter(TagScope scope) {
    items = content.apply(scope).iterator();
    List<TagScope> inner = scope.innerScopes();
    if (!inner.isEmpty()) {
      path.push(inner.iterator());
    }
  }
}
