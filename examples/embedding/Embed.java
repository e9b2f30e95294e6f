import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.urbi.kernel.Kernel;
import org.urbi.kernel.embed.UrbiError;
import org.urbi.kernel.embed.UrbiValue;

/** A Java program with urbiscript inside. */
public class Embed {
  public static void main(String[] args) throws Exception {
    // Build: a kernel of our own. Simulated time makes the example quick, and the same each time.
    try (Kernel kernel = Kernel.builder().virtualTime(true).start()) {
      // Evaluate: values come back as Java values.
      System.out.println("eval: " + kernel.eval("1 + 2"));
      int size = kernel.eval("[1, 2, 3].size", int.class);
      System.out.println("size: " + size);

      // Define, both ways, and call.
      kernel.define("half", arguments -> (Double) arguments.getFirst() / 2);
      kernel.eval("function mean(a, b) { half(a + b) }");
      System.out.println("call: " + kernel.call("mean", 20, 64));

      // Objects are handles, to be used from any thread.
      UrbiValue robot = kernel.eval("class Robot { var x = 0; var bumped = Event.new }; Robot",
          UrbiValue.class);
      robot.set("x", 1);

      // Subscribe: listeners run on threads of their own.
      BlockingQueue<Object> bumps = new LinkedBlockingQueue<>();
      BlockingQueue<Object> places = new LinkedBlockingQueue<>();
      kernel.onEvent("Robot.bumped", bumps::add);
      kernel.onChange("Robot.x", places::add);
      kernel.eval("Robot.bumped!(\"left\", 2) | Robot.x = 42");
      System.out.println("event: " + bumps.take() + ", change: " + places.take());

      // Output of urbiscript goes to System.out, errors come as exceptions.
      kernel.eval("sleep(1h) | echo(\"an hour later\")");
      try {
        kernel.eval("Robot.fly");
      } catch (UrbiError e) {
        System.out.println(e.report());
      }
    } // Stop: the kernel ends with the block.
    System.out.println("stopped");
  }
}
