/**
 * What all programs' command lines have in common; the only place that knows picocli. Options are
 * declared by calls and not by annotations: nothing is looked up by reflection at start-up.
 */
package org.urbi.server.options;
