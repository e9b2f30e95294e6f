package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.object.UrbiObject;

/** The tree of the code under tags, and what is done to a tag (manual, "Tag"). */
class TagScopeTest {
  private final Loop loop = new Loop();
  private final UrbiObject value = loop.object();
  private final UrbiObject object = loop.object();
  private final TagState tag = new TagState(object);
  private final TagState other = new TagState(null);
  private final TagScope root = new TagScope();
  private final TagScope outer = new TagScope(tag, root, null);
  private final TagScope inner = new TagScope(other, outer, null);
  private final List<String> told = new ArrayList<>();

  /** A handler that writes down what it is told. */
  private TagScope.Attachment handler(String name) {
    return by -> told.add(name + (by == outer ? " outer" : by == inner ? " inner" : " " + by));
  }

  private Job jobUnder(TagScope scope) {
    return new Job(loop.scheduler, job -> {}, "job", null, scope, null, 0);
  }

  @Test
  void scopesFormATree() {
    assertSame(tag, outer.tag());
    assertSame(outer, inner.parent());
    assertEquals(List.of(0, 1, 2), List.of(root.depth(), outer.depth(), inner.depth()));
    assertEquals(List.of(other, tag), inner.tags());
    assertSame(object, tag.owner());
    Job owner = jobUnder(root);
    assertSame(owner, new TagScope(tag, root, owner).owner());
    TagScope branch = TagScope.branch(owner.scheduler(), other, outer);
    assertSame(other, branch.tag());
    assertSame(outer, branch.parent());
    assertNull(branch.owner());
  }

  @Test
  void aJobIsUnderItsScopeUntilItEnds() {
    assertTrue(tag.isIdle());
    Job job = jobUnder(inner);
    assertEquals(List.of(job), Loop.jobsUnder(root));
    assertFalse(tag.isIdle());
    assertFalse(other.isIdle());
    inner.remove(job);
    assertEquals(List.of(), Loop.jobsUnder(root));
    assertTrue(tag.isIdle());
  }

  @Test
  void whatStartsUnderAScopeThatWasLeftKeepsItAlive() {
    Job job = jobUnder(inner);
    TagScope.Attachment handler = handler("never");
    outer.close();
    inner.add(handler);
    inner.end();
    assertTrue(tag.scopes.contains(outer));
    inner.remove(job);
    assertTrue(other.scopes.contains(inner));
    inner.remove(handler);
    assertFalse(other.scopes.contains(inner));
    assertFalse(tag.scopes.contains(outer));
    assertEquals(List.of(), Loop.jobsUnder(root));
  }

  @Test
  void aScopeThatIsStillOpenStays() {
    Job job = jobUnder(outer);
    outer.remove(job);
    assertTrue(tag.scopes.contains(outer));
    outer.close();
    assertTrue(tag.scopes.contains(outer), "the inner one is open");
    inner.close();
    assertFalse(tag.scopes.contains(outer));
  }

  /** A scope that is over is no more in the tree: what is added to it is of no concern. */
  @Test
  void aScopeThatIsOverLeavesTheTree() {
    inner.close();
    Job late = jobUnder(inner);
    assertEquals(List.of(), Loop.jobsUnder(outer));
    outer.close();
    outer.add(late);
    assertEquals(List.of(), Loop.jobsUnder(root));
  }

  @Test
  void aScopeIsAsFrozenAsThoseAround() {
    assertFalse(inner.isFrozen());
    tag.freeze();
    assertTrue(inner.isFrozen());
    other.freeze();
    assertTrue(inner.isFrozen());
    assertTrue(outer.isFrozen());
    assertFalse(root.isFrozen());
    tag.unfreeze();
    assertTrue(inner.isFrozen());
    assertFalse(outer.isFrozen());
    assertFalse(tag.isFrozen());
    assertTrue(other.isFrozen());
    other.unfreeze();
    assertFalse(inner.isFrozen());
  }

  @Test
  void aBlockedTagKeepsItsValueUntilItIsUnblocked() {
    other.block(loop.scheduler, value);
    assertTrue(other.isBlocked());
    assertFalse(tag.isBlocked());
    assertSame(value, other.blockedValue());
    other.unblock();
    assertFalse(other.isBlocked());
    assertNull(other.blockedValue());
  }

  @Test
  void aHandlerHearsWhichTagWasStopped() {
    outer.add(handler("a"));
    inner.add(handler("b"));
    assertEquals(2, root.allAttachments().size());
    other.stop(loop.scheduler, value);
    assertEquals(List.of("b inner"), told);
    tag.stop(loop.scheduler, value);
    assertEquals(List.of("b inner", "a outer", "b outer"), told);
    told.clear();
    tag.dismiss();
    assertEquals(List.of("a null", "b null"), told);
  }

  @Test
  void aBlockedTagIsStopped() {
    outer.add(handler("a"));
    tag.block(loop.scheduler, value);
    assertEquals(List.of("a outer"), told);
  }

  /** What waits for something that is gone. */
  private static final class Gone implements TagScope.Attachment {
    @Override
    public void stopped(TagScope by) {}

    @Override
    public boolean isGone() {
      return true;
    }
  }

  @Test
  void handlersOfWhatIsGoneAreForgottenNowAndThen() {
    for (int i = 0; i < 10; i++) {
      outer.add(handler("stays"));
    }
    for (int i = 0; i < 6; i++) {
      outer.add(new Gone());
    }
    assertEquals(16, outer.allAttachments().size());
    outer.add(handler("one more"));
    assertEquals(11, outer.allAttachments().size());
    for (int i = 0; i < 11; i++) {
      outer.add(new Gone());
    }
    assertEquals(22, outer.allAttachments().size());
    outer.add(new Gone());
    assertEquals(11, outer.allAttachments().size());
  }

  @Test
  void aWeakOneStandsForItsHandler() {
    TagScope.Attachment handler = handler("weak");
    WeakAttachment weak = new WeakAttachment(handler);
    weak.keep(true);
    assertFalse(weak.isGone());
    weak.stopped(outer);
    weak.keep(false);
    weak.stopped(null);
    assertEquals(List.of("weak outer", "weak null"), told);
    WeakAttachment empty = new WeakAttachment(null);
    assertTrue(empty.isGone());
    empty.keep(true);
    empty.stopped(outer);
    assertEquals(2, told.size());
  }

  @Test
  void thatTheLastJobEndsIsToldOnce() {
    List<Job> ended = new ArrayList<>();
    TagScope scope = new TagScope(tag, loop.scheduler.rootScope(), null);
    for (int i = 0; i < 3; i++) {
      loop.start(scope, job -> job.sleepUntil(Loop.SECOND)).onEnd(() -> ended.add(null));
    }
    tag.onIdle(() -> loop.say("idle after " + ended.size()));
    tag.onIdle(() -> loop.say("and again"));
    loop.run();
    assertEquals(List.of("idle after 3", "and again"), loop.said);
  }

  @Test
  void whatIsStoppedReturnsTheValue() {
    loop.start(job -> {
      TagScope scope = job.enter(tag);
      loop.start(by -> tag.stop(loop.scheduler, value));
      try {
        job.sleepUntil(Loop.SECOND);
      } catch (TagStop stop) {
        assertSame(scope, stop.scope());
        assertSame(value, stop.value());
        assertFalse(stop.isInterruption());
        loop.say("stopped");
      }
      job.leave(scope);
      assertSame(loop.scheduler.rootScope(), job.scope());
    });
    assertEquals(List.of("stopped"), loop.run());
    assertFalse(tag.scopes.stream().anyMatch(scope -> scope != outer));
  }

  @Test
  void aScopeIsAfterAStatementIfItOrOneAroundBelongsToALaterOne() {
    assertFalse(inner.isAfter(0));
    outer.isForStatement(3);
    assertFalse(inner.isAfter(3));
    assertTrue(inner.isAfter(2));
    assertTrue(outer.isAfter(2));
    assertFalse(root.isAfter(0));
    inner.isForStatement(5);
    assertTrue(inner.isAfter(4));
    assertFalse(outer.isAfter(4));
  }

  /** Of the jobs that have entered a tag, only those that are not too young count. */
  @Test
  void aScopeIsWithinATagThatAnOlderJobHasEntered() {
    Job older = jobUnder(root);
    Job younger = jobUnder(root);
    TagState entered = new TagState();
    TagScope byOlder = new TagScope(entered, outer, older);
    TagScope below = new TagScope(other, byOlder, null);
    TagScope byYounger = new TagScope(entered, outer, younger);
    assertTrue(byOlder.isOf(older.number()));
    assertFalse(byYounger.isOf(older.number()));
    assertTrue(byYounger.isOf(younger.number()));
    assertTrue(outer.isOf(0));
    assertTrue(below.isWithin(entered, older.number()));
    assertFalse(byYounger.isWithin(entered, older.number()));
    assertFalse(outer.isWithin(entered, Long.MAX_VALUE));
    assertTrue(entered.isStopped(jobUnder(below), older.number()));
    assertFalse(entered.isStopped(jobUnder(byYounger), older.number()));
    assertFalse(entered.isStopped(older, Long.MAX_VALUE));
  }

  @Test
  void onlyWhatStatementsUpToANumberHaveBegunIsStopped() {
    TagState shared = new TagState();
    TagScope early = new TagScope(new TagState(), root, null);
    TagScope late = new TagScope(new TagState(), root, null);
    early.isForStatement(1);
    late.isForStatement(2);
    new TagScope(shared, early, null).add(handler("early"));
    new TagScope(shared, late, null).add(handler("late"));
    shared.stopStatements(loop.scheduler, value, 1);
    assertEquals(1, told.size());
    assertTrue(told.getFirst().startsWith("early "), told::toString);
  }

  @Test
  void aScopeIsOverWhenItWasEndedAndNothingIsLeft() {
    Job job = jobUnder(inner);
    assertFalse(inner.isOver());
    inner.end();
    assertFalse(inner.isOver());
    inner.remove(job);
    assertTrue(inner.isOver());
    assertFalse(outer.isOver());
  }

  @Test
  void whatIsDetachedOutlivesItsConnection() {
    assertFalse(inner.isDetached());
    TagScope detached = new TagScope(TagState.ofDetached(), outer, null);
    assertTrue(detached.isDetached());
    assertTrue(new TagScope(other, detached, null).isDetached());
    assertFalse(tag.isDetached());
  }

  @Test
  void aTagIsFoundByItsNumber() {
    TagScope branch = TagScope.branch(loop.scheduler, other, root);
    TagScope below = TagScope.branch(loop.scheduler, tag, branch);
    assertEquals(List.of(1L, 2L), List.of(other.number(), tag.number()));
    assertSame(other, branch.tag(1));
    assertSame(tag, branch.tag(2));
    assertSame(tag, below.tag(2));
    assertNull(below.tag(1));
    assertNull(root.tag(3));
  }

  @Test
  void aTagCanRunWhileAJobUnderItDoesNotWait() {
    TagScope scope = new TagScope(other, loop.scheduler.rootScope(), null);
    assertFalse(other.canRun());
    loop.start(
        scope,
        job -> {
          assertTrue(job.canRun());
          assertTrue(other.canRun());
          job.sleepUntil(Loop.SECOND);
        });
    loop.start(by -> {
      by.yieldNow();
      assertFalse(other.canRun());
      assertEquals(Loop.SECOND, Loop.jobsUnder(scope).getFirst().deadline());
    });
    loop.run();
  }

  @Test
  void aTagIsOnlyOfALobbyIfAllItsJobsAre() {
    UrbiObject lobby = loop.lobby();
    new Job(loop.scheduler, job -> {}, "job", lobby, inner, null, 0);
    assertTrue(tag.isOnlyOf(lobby));
    assertFalse(tag.isOnlyOf(loop.lobby()));
    new Job(loop.scheduler, job -> {}, "job", loop.lobby(), inner, null, 0);
    assertFalse(tag.isOnlyOf(lobby));
  }
}
