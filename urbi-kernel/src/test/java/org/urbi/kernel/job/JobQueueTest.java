package org.urbi.kernel.job;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Jobs in line. */
class JobQueueTest {
  private final Loop loop = new Loop();
  private final JobQueue queue = new JobQueue();
  private final Job one = job();
  private final Job two = job();
  private final Job three = job();

  /** One that no scheduler knows. */
  private Job job() {
    return new Job(
        loop.scheduler, self -> {}, "test", loop.object(), loop.scheduler.rootScope(), null, 0);
  }

  @Test
  void jobsComeOutInTheirOrder() {
    queue.add(two);
    queue.add(three);
    queue.addFirst(one);
    assertEquals(3, queue.size());
    assertSame(one, queue.poll());
    assertSame(three, queue.pollLast());
    assertSame(two, queue.poll());
    assertNull(queue.poll());
    assertNull(queue.pollLast());
    assertTrue(queue.isEmpty());
  }

  @Test
  void jobIsInOneQueueAtATime() {
    JobQueue other = new JobQueue();
    queue.add(one);
    queue.add(two);
    queue.add(one);
    other.add(two);
    other.addFirst(one);
    assertEquals(2, queue.size());
    assertTrue(other.isEmpty());
    assertSame(one, queue.poll());
    other.add(one);
    assertSame(two, queue.poll());
    assertSame(one, other.poll());
  }

  @Test
  void jobLeavesFromAnywhere() {
    queue.add(one);
    queue.add(two);
    queue.add(three);
    JobQueue.leave(two);
    JobQueue.leave(two);
    assertFalse(queue.hasAny(job -> job == two));
    assertTrue(queue.hasAny(job -> job == three));
    JobQueue.leave(three);
    queue.add(two);
    assertSame(one, queue.poll());
    assertSame(two, queue.poll());
    assertEquals(0, queue.size());
  }
}
