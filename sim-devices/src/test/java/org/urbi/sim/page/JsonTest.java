package org.urbi.sim.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class JsonTest {
  @Test
  void valuesAreWritten() {
    assertEquals("[1,-0.5,12,true,null]", Json.text(Arrays.asList(1, -0.5, 12.0, true, null)));
    assertEquals(
        "{\"a\":[],\"b\":{}}".length(), Json.text(Map.of("a", List.of(), "b", Map.of())).length());
    assertEquals(
        "[1.0E-5,0,null,null,1.0E20]",
        Json.text(new double[] {1e-5, 1e-9, Double.NaN, Double.POSITIVE_INFINITY, 1e20}));
    assertEquals("\"\\\"\\\\\\u000a\\u003c\\u00e9\"", Json.text("\"\\\n<é"));
    assertThrows(IllegalArgumentException.class, () -> Json.text(new Object()));
  }
}
