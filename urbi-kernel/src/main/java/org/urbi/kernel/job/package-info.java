/** Jobs, tags' scopes and the tick loop which runs them; knows nothing of urbiscript code. */
package org.urbi.kernel.job;
