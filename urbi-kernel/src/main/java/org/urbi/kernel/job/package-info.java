/**
 * Jobs, the scopes of tags, and the tick loop that runs them. It knows nothing of urbiscript code.
 */
@NullMarked
package org.urbi.kernel.job;

import org.jspecify.annotations.NullMarked;
