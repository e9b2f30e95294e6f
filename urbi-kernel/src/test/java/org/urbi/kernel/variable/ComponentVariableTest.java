package org.urbi.kernel.variable;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;
import org.urbi.kernel.Kernel;
import urbi.InputPort;
import urbi.UBinary;
import urbi.UObject;
import urbi.UVar;

/** What only components do with variables (manual, "The UObject API"). */
class ComponentVariableTest {
  /** Takes pictures, and has a motor with a range. */
  public static final class Robot extends UObject {
    private final UVar image = new UVar();
    private final UVar number = new UVar();
    private final UVar angle = new UVar();
    private int taken;

    public Robot(String name) {
      super(name);
      UBindVar(image, "image");
      UBindVar(number, "number");
      UBindVar(angle, "angle");
      image.setBypass(true);
      UOwned(angle);
      angle.setValue(0);
      UBindFunctions("take", "say", "bypass", "own", "sense", "goal", "datagrams", "when");
    }

    /** Writes a picture of three bytes without a copy. */
    public int take() {
      image.setValue(new UBinary("rgb 1 1", new byte[] {(byte) ++taken, 0, 0}));
      return taken;
    }

    /** Writes a text where pictures are. */
    public void say(String text) {
      image.setValue(text);
    }

    public void bypass(boolean on) {
      image.setBypass(on);
    }

    /** The pictures are its own. */
    public void own() {
      UOwned(image);
    }

    public void sense(double value) {
      angle.setValue(value);
    }

    /** What the angle is to be. */
    public double goal() {
      return angle.in();
    }

    public void datagrams(boolean on) {
      number.useRTP(on);
    }

    /** Whether the number was written after the angle. */
    public boolean when() {
      return angle.timestamp() < number.timestamp();
    }
  }

  /** Has a port. */
  public static final class Viewer extends UObject {
    private final InputPort input = new InputPort(this, "input");
    private String seen = "";

    public Viewer(String name) {
      super(name);
      UNotifyChange(input, "look");
      UBindFunctions("shown");
    }

    /** Somebody has written to the port. */
    public void look(UVar changed) {
      seen += changed.getUValue().toString() + ";";
    }

    /** What it has been shown. */
    public String shown() {
      return seen;
    }
  }

  private static void hold(String text) {
    ConsoleTranscript.checkWith(List.of(Robot.class, Viewer.class), text);
  }

  @Test
  void inBypassModeAReaderWaitsForTheNext() {
    hold(
        """
        var r = Robot.new|;
        { echo(r.image.data.size); echo("one") },
        { echo(r.image.keywords); echo("other") },
        sleep(400ms);
        r.take;
        [00000400] 1
        [00000400] *** 3
        [00000400] *** rgb 1 1
        [00000400] *** one
        [00000400] *** other
        { r.image|; echo("never") },
        r.take;
        [00000400] 2
        [00000400] *** never
        { echo(r.image == nil) },
        sleep(1s);
        [00000900] *** true
        """);
  }

  @Test
  void inBypassModeHooksReadAtOnceAndNothingIsLeft() {
    hold(
        """
        var r = Robot.new|;
        var sizes = []|;
        var id = r.&image.notifyChange(closure () { sizes << r.image.data.size })|;
        r.take;
        [00000000] 1
        r.take;
        [00000000] 2
        sizes;
        [00000000] [3, 3]
        r.&image.removeNotifyChange(id);
        [00000000] true
        r.&image.val;
        r.&image.valsensor;
        """);
  }

  @Test
  void inBypassModeWhatIsNoPictureStays() {
    hold(
        """
        var r = Robot.new|;
        r.image = 12;
        [00000000] 12
        r.image;
        [00000000] 12
        r.take;
        [00000000] 1
        r.&image.val;
        r.bypass(true);
        r.image = 13|;
        r.bypass(true);
        r.&image.val;
        r.image = 14|;
        r.bypass(false);
        r.image;
        [00000000] 14
        """);
  }

  @Test
  void withoutBypassModeThePictureStays() {
    hold(
        """
        var r = Robot.new|;
        r.bypass(false);
        r.image;
        r.take;
        [00000000] 1
        r.image.keywords;
        [00000000] "rgb 1 1"
        r.take;
        [00000000] 2
        r.image.data.size;
        [00000000] 3
        """);
  }

  @Test
  void anOwnedOneInBypassModeKeepsItsTarget() {
    hold(
        """
        var r = Robot.new|;
        r.own;
        r.image = "goal";
        [00000000] "goal"
        r.take;
        [00000000] 1
        r.&image.valsensor;
        r.&image.val;
        [00000000] "goal"
        { echo(r.image.data.size) },
        sleep(400ms);
        r.take;
        [00000400] 2
        [00000400] *** 3
        """);
  }

  @Test
  void conditionsDoNotWaitInBypassMode() {
    hold(
        """
        var r = Robot.new|;
        at (r.image != nil) echo("picture");
        echo("goes on");
        [00000000] *** goes on
        r.take;
        [00000000] 1
        [00000000] *** picture
        """);
  }

  @Test
  void thePortKeepsNothing() {
    hold(
        """
        var v = Viewer.new|;
        v.input = 3;
        [00000000] 3
        v.input = 4;
        [00000000] 4
        v.shown;
        [00000000] "3;4;"
        v.input;
        """);
  }

  @Test
  void targetsOutOfRangeAreWarnedOfOnce() {
    hold(
        """
        var r = Robot.new|;
        r.angle->rangemin = -1|;
        r.angle->rangemax = 2|;
        r.angle = 2|;
        r.goal;
        [00000000] 2
        r.angle = 3|;
        r.angle = 4|;
        r.goal;
        [00000000] 2
        r.angle = 0|;
        r.angle = -7|;
        r.goal;
        [00000000] -1
        r.angle;
        [00000000] 0
        r.sense(1);
        r.angle;
        [00000000] 1
        """);
  }

  @Test
  void theLogSaysWhichRangeIsLeft() {
    List<String> log = Collections.synchronizedList(new ArrayList<>());
    try (Kernel kernel = Kernel.builder().virtualTime(true).log(log::add).start()) {
      kernel.start(Robot.class);
      kernel.eval("var Global.r = Robot.new|; r.angle->rangemin = -1|; r.angle->rangemax = 2|;");
      kernel.eval("r.angle = 2|; r.angle = 3|; r.angle = 4|; r.angle = -1|; r.angle = -7.5|;");
    }
    List<String> warnings = log.stream().filter(line -> line.contains("range")).toList();
    assertEquals(2, warnings.size(), warnings.toString());
    assertTrue(
        warnings.get(0).endsWith(".angle: 3.0 is more than 2.0, the rangemax: limited to that"),
        warnings.get(0));
    assertTrue(
        warnings.get(1).endsWith(".angle: -7.5 is less than -1.0, the rangemin: limited to that"),
        warnings.get(1));
  }

  @Test
  void conditionsHearWhatTheOwnerHasSensed() {
    hold(
        """
        var r = Robot.new|;
        at (r.angle > 0.5) echo("up") onleave echo("down");
        r.angle = 9|;
        r.sense(1);
        [00000000] *** up
        sleep(1s);
        r.sense(0);
        [00001000] *** down
        """);
  }

  @Test
  void itKnowsWhenItWasWritten() {
    hold(
        """
        var r = Robot.new|;
        sleep(1s);
        r.number = 1|;
        r.when;
        [00001000] true
        sleep(1s);
        r.sense(1);
        r.when;
        [00002000] false
        """);
  }

  @Test
  void aComponentSwitchesItsDatagrams() {
    hold(
        """
        var r = Robot.new|;
        r.&number.rtp;
        r.datagrams(true);
        r.&number.rtp;
        [00000000] true
        r.datagrams(false);
        r.&number.rtp;
        [00000000] false
        """);
  }

  @Test
  void linksOfAComponentAreListedUntilTheyAreCut() {
    hold(
        """
        var r = Robot.new|;
        var v = Viewer.new|;
        var c = r.&number >> v.&input|;
        var d = r.&angle >> v.&input|;
        c.asString;
        [00000000] "Robot_0x7f000010.number >> Viewer_0x7f000020.input"
        Subscription.getAll.size;
        [00000000] 2
        Subscription.getAll[0] === c;
        [00000000] true
        c.disconnect;
        Subscription.getAll.size;
        [00000000] 1
        r.number = 1|;
        r.sense(5);
        v.shown;
        [00000000] "5;"
        """);
  }
}
