package org.urbi.kernel.library.uobject;

import org.junit.jupiter.api.Test;
import org.urbi.kernel.ConsoleTranscript;

/** Links between variables, subscriptions, and their terms, as urbiscript sees them. */
class LinksTest {
  private static final String TWO_VARIABLES =
      """
      var o = Object.new|; var o.x = 0|; var o.y = 0|;
      var x = UVar.new(o, "x")|; var y = UVar.new(o, "y")|;
      function ends(v) { v.initialName.split(".")[1] }|;
      """;

  @Test
  void aLinkLeadsValuesUntilItIsEndedAndBeginsElsewhere() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            var link = x >> y|;
            o.x = 1|; o.y;
            [00000000] 1
            x.changeConnections.size; Subscription.getAll.size;
            [00000000] 1
            [00000000] 1
            link.disconnect;
            o.x = 2|; o.y;
            [00000000] 1
            x.changeConnections.size; Subscription.getAll.size;
            [00000000] 0
            [00000000] 0
            var o.z = 0|; var z = UVar.new(o, "z")|;
            link.reconnect(z);
            o.z = 3|; o.y;
            [00000000] 3
            Subscription.getAll.size;
            [00000000] 1
            """);
  }

  @Test
  void theOtherArrowLeadsTheOtherWay() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            var link = x << y|;
            o.y = 4|; o.x;
            [00000000] 4
            o.x = 5|; o.y;
            [00000000] 4
            link.asString == y.initialName + " >> " + x.initialName;
            [00000000] true
            UConnection.asString;
            [00000000] "UConnection"
            """);
  }

  @Test
  void whatIsDisabledLeadsNothingAndCounts() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            var link = x >> y|;
            link.enabled;
            [00000000] true
            link.enabled = false|; link.enabled;
            [00000000] false
            o.x = 1|; o.y; link.callCount;
            [00000000] 0
            [00000000] 0
            link.enabled = true|; o.x = 2|; o.y; link.callCount;
            [00000000] 2
            [00000000] 1
            link.resetStats; link.callCount;
            [00000000] 0
            o.x = 3|; link.callCount; uobjects.resetConnectionStats; link.callCount;
            [00000000] 1
            [00000000] 0
            """);
  }

  @Test
  void theRateIsLimited() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            var link = x >> y|;
            link.minInterval;
            [00000000] 0
            link.minInterval = 2s|; link.minInterval;
            [00000000] 2
            o.x = 1|; o.y;
            [00000000] 1
            sleep(1s); o.x = 2|; o.y;
            [00001000] 1
            sleep(1s); o.x = 3|; o.y;
            [00002000] 3
            """);
  }

  @Test
  void callsAreMadeInAJobOfTheirOwnIfWanted() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            var link = x >> y|;
            link.asynchronous;
            [00000000] false
            link.asynchronous = true|; link.asynchronous;
            [00000000] true
            """);
  }

  @Test
  void aSubscriptionListensToEvents() {
    ConsoleTranscript.check(
        """
        var e = Event.new|; var f = Event.new|;
        var s = Subscription.new(function (a) { echo(a) })|;
        s.reconnect(e);
        e!(1);
        [00000000] *** 1
        s.reconnect(f);
        e!(2);
        f!(3);
        [00000000] *** 3
        s.disconnect;
        f!(4);
        """);
  }

  @Test
  void whatHasNoEndCannotBeReconnected() {
    ConsoleTranscript.check(
        TWO_VARIABLES
            + """
            try { Subscription.new.reconnect(Event.new) } catch (var e) { echo("no function") };
            [00000000] *** no function
            try { UConnection.reconnect(x) } catch (var e) { echo("no target") };
            [00000000] *** no target
            """);
  }
}
