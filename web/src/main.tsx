import { render } from "preact";
import { App } from "./parts/App";
import * as player from "./past/player";
import * as route from "./route";
import { begin } from "./store";
import { language, speak } from "./texts";
import * as theme from "./theme";
import "./style.css";
import "./past.css";
import "./shift.css";

theme.begin();
speak(language.value);
route.begin();
player.begin();
begin();
render(<App />, document.getElementById("page") as HTMLElement);
