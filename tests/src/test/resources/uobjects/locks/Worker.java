import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import urbi.LockMode;
import urbi.LockSpec;
import urbi.UObject;
import urbi.UVar;

/** Works on threads, and tells how many calls ran at a time at most. */
public class Worker extends UObject {
  static {
    UStart(Worker.class);
  }

  private static final AtomicInteger RUNNING = new AtomicInteger();
  private static int most;

  private UVar done = new UVar();

  public Worker(String name) {
    super(name);
    UBindVar(done, "done");
    done.setValue(0);
    UBindThreadedFunctionRename("work", "free", LockMode.LOCK_NONE);
    UBindThreadedFunctionRename("work", "byFunction", LockMode.LOCK_FUNCTION);
    UBindThreadedFunctionRename("work", "byFunctionToo", LockMode.LOCK_FUNCTION);
    UBindThreadedFunctionRename("work", "byInstance", LockMode.LOCK_INSTANCE);
    UBindThreadedFunctionRename("work", "byInstanceToo", LockMode.LOCK_INSTANCE);
    UBindThreadedFunctionRename("work", "byClass", LockMode.LOCK_CLASS);
    UBindThreadedFunctionRename("work", "byModule", LockMode.LOCK_MODULE);
    UBindThreadedFunctionRename("work", "dropping", LockSpec.LOCK_FUNCTION_DROP);
    UBindThreadedFunctionRename("work", "keeping", LockSpec.LOCK_FUNCTION_KEEP_ONE);
    UBindThreadedFunction("hang", LockMode.LOCK_NONE);
    UBindThreadedFunction("fail", LockMode.LOCK_NONE);
    UBindFunctions("most", "limit", "pause");
  }

  public String work(String text) throws InterruptedException {
    int running = RUNNING.incrementAndGet();
    synchronized (Worker.class) {
      most = Math.max(most, running);
    }
    Thread.sleep(80);
    done.setValue(done.intValue() + 1);
    RUNNING.decrementAndGet();
    return text;
  }

  public void hang() throws InterruptedException {
    new CountDownLatch(1).await();
  }

  public void fail() {
    throw new IllegalStateException("pan");
  }

  /** The greatest number of calls at a time since the last time it was asked. */
  public int most() {
    synchronized (Worker.class) {
      int before = most;
      most = 0;
      return before;
    }
  }

  public void limit(int threads) {
    setThreadLimit(threads);
  }

  /** Lets others run in the middle of a synchronous call. */
  public void pause() {
    yield_for(20_000);
  }
}
