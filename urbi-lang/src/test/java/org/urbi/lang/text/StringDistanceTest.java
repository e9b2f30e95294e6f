package org.urbi.lang.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.urbi.lang.text.StringDistance.ClosestName;

class StringDistanceTest {
  private static final int PAIRS = 20_000;

  /** Few letters, so that many words are similar; the last two share a bit with the first. */
  private static final String LETTERS = "abcAB$\u00e9!\u0121";

  @Test
  void ofWordsThatAreAsSimilarTheOneAtHandOrWithOneMoreOrLessAtItsEndIsMeant() {
    ClosestName atTheEnd = new ClosestName("vall");
    atTheEnd.consider("val");
    atTheEnd.consider("wall");
    assertEquals("val", atTheEnd.meant());
    ClosestName twoErrors = new ClosestName("assert_eq");
    twoErrors.consider("assert_");
    twoErrors.consider("assert_op");
    assertEquals("assert_op", twoErrors.meant());
    ClosestName atHand = new ClosestName("sped");
    atHand.consider("shed", true);
    atHand.consider("speed");
    assertEquals("shed", atHand.meant());
    atHand.consider("Sped");
    assertEquals("shed", atHand.meant());
  }

  private static String word(SplittableRandom random) {
    StringBuilder word = new StringBuilder();
    for (int left = random.nextInt(8); left > 0; left--) {
      word.append(LETTERS.charAt(random.nextInt(LETTERS.length())));
    }
    return word.toString();
  }

  /** What is passed over without counting errors has too many of them. */
  @Test
  void nameIsMeantWhereThereAreFewErrors() {
    SplittableRandom random = new SplittableRandom(7);
    int similar = 0;
    for (int i = 0; i < PAIRS; i++) {
      String name = word(random);
      String candidate = word(random);
      int shorter = Math.min(name.length(), candidate.length());
      int most = shorter < 2 ? 0 : shorter < 3 ? 1 : 2;
      int errors =
          StringDistance.distance(
              name.toLowerCase(Locale.ROOT), candidate.toLowerCase(Locale.ROOT), () -> {});
      boolean isMeant = !name.equals(candidate) && Math.max(1, errors) <= most;
      similar += isMeant ? 1 : 0;
      ClosestName closest = new ClosestName(name);
      closest.consider(candidate);
      assertEquals(isMeant ? candidate : null, closest.meant(), name + " " + candidate);
    }
    assertTrue(similar > PAIRS / 100, "only " + similar);
    assertTrue(similar < PAIRS / 2, "as many as " + similar);
  }
}
