//! Pages opened in a real browser: headless Chromium, driven through chromedriver by the WebDriver protocol (W3C), of
//! which a few requests are enough. Where either program is absent, tests say so and pass.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

pub(crate) mod looks;

/// What is waited for at most: machines that test are busy.
const PATIENCE: Duration = Duration::from_secs(180);

/// A browser with one window, closed when it is dropped.
pub(crate) struct Browser {
    driver: Child,
    port: u16,
    session: String,
}

impl Browser {
    /// Starts it; nothing, with a notice, where it is not installed.
    pub(crate) fn start() -> Option<Self> {
        let chromium =
            ["chromium", "chromium-browser", "google-chrome"].into_iter().find(|name| is_there(name));
        let (Some(chromium), true) = (chromium, is_there("chromedriver")) else {
            // past the test harness, which keeps what is printed to itself
            let _ = writeln!(
                std::io::stderr(),
                "NOTICE: chromium or chromedriver is not installed: pages are not opened in a browser"
            );
            return None;
        };
        let listener = std::net::TcpListener::bind("127.0.0.1:0").expect("a free port");
        let port = listener.local_addr().expect("it has an address").port();
        drop(listener);
        let driver = Command::new("chromedriver")
            .arg(format!("--port={port}"))
            .stdin(Stdio::null())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("chromedriver starts");
        let mut browser = Self { driver, port, session: String::new() };
        wait("chromedriver answers", || {
            browser.try_request("GET", "/status", &Value::Null).is_some_and(|status| status["ready"] == true)
        });
        let capabilities = json!({ "capabilities": { "alwaysMatch": {
            "goog:chromeOptions": { "binary": which(chromium), "args": [
                "--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--enable-unsafe-swiftshader",
                "--window-size=1200,1400",
            ] },
            "goog:loggingPrefs": { "browser": "ALL" },
        } } });
        let answer = browser.request("POST", "/session", &capabilities);
        answer["sessionId"].as_str().expect("a session").clone_into(&mut browser.session);
        Some(browser)
    }

    /// Opens a file.
    pub(crate) fn open(&self, page: &Path) {
        self.command("url", &json!({ "url": format!("file://{}", page.display()) }));
    }

    /// What a script returns.
    pub(crate) fn script(&self, script: &str) -> Value {
        self.command("execute/sync", &json!({ "script": script, "args": [] }))
    }

    /// Errors on the console since the page was opened.
    pub(crate) fn console_errors(&self) -> Vec<String> {
        let log = self.command("se/log", &json!({ "type": "browser" }));
        let errors =
            log.as_array().map_or(&[][..], Vec::as_slice).iter().filter(|entry| entry["level"] == "SEVERE");
        errors.map(|entry| entry["message"].to_string()).collect()
    }

    /// Makes the window as wide as this, px, without a frame.
    pub(crate) fn resize(&self, width: u64) {
        let size = json!({ "width": width, "height": 1400, "deviceScaleFactor": 1, "mobile": false });
        self.emulate("setDeviceMetricsOverride", &size);
    }

    /// Lets the user prefer a scheme of colours: `light` or `dark`.
    pub(crate) fn prefer(&self, scheme: &str) {
        let feature = json!({ "name": "prefers-color-scheme", "value": scheme });
        self.emulate("setEmulatedMedia", &json!({ "features": [feature] }));
    }

    /// Shows the page as it is laid out on paper, or on the screen again.
    pub(crate) fn emulate_paper(&self, paper: bool) {
        self.emulate("setEmulatedMedia", &json!({ "media": if paper { "print" } else { "" } }));
    }

    fn emulate(&self, what: &str, parameters: &Value) {
        self.command(
            "goog/cdp/execute",
            &json!({ "cmd": format!("Emulation.{what}"), "params": parameters }),
        );
    }

    /// Prints the page; the length of what a printer would get.
    pub(crate) fn print(&self) -> usize {
        self.command("print", &json!({})).as_str().map_or(0, str::len)
    }

    /// Clicks what a selector finds first, as a user does.
    pub(crate) fn click(&self, selector: &str) {
        let [x, y] = self.middle(selector);
        self.pointer(&[
            moved(x, y),
            json!({ "type": "pointerDown", "button": 0 }),
            json!({ "type": "pointerUp", "button": 0 }),
        ]);
    }

    /// Moves the pointer to a place in the window.
    pub(crate) fn hover(&self, x: f64, y: f64) {
        // two moves: plotly reads a value when the pointer moves over a plot
        self.pointer(&[moved(x - 3.0, y - 3.0), moved(x, y)]);
    }

    fn middle(&self, selector: &str) -> [f64; 2] {
        let script = format!(
            "const b = document.querySelector({}).getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2];",
            json!(selector)
        );
        let place = self.script(&script);
        [0, 1].map(|i| place[i].as_f64().expect("an element of the page"))
    }

    fn pointer(&self, actions: &[Value]) {
        self.command(
            "actions",
            &json!({ "actions": [{ "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" },
                "actions": actions }] }),
        );
    }

    /// Keeps a picture of the window.
    pub(crate) fn screenshot(&self) -> String {
        let path = format!("/session/{}/screenshot", self.session);
        self.request("GET", &path, &Value::Null).as_str().unwrap_or_default().to_owned()
    }

    fn command(&self, name: &str, body: &Value) -> Value {
        self.request("POST", &format!("/session/{}/{name}", self.session), body)
    }

    fn request(&self, method: &str, path: &str, body: &Value) -> Value {
        let value = self.try_request(method, path, body).unwrap_or_else(|| panic!("no answer to {path}"));
        assert!(value["error"].is_null() || !value["stacktrace"].is_string(), "{path}: {}", value["message"]);
        value
    }

    /// One request of the protocol: HTTP with JSON, a connection each.
    fn try_request(&self, method: &str, path: &str, body: &Value) -> Option<Value> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).ok()?;
        stream.set_read_timeout(Some(4 * PATIENCE)).ok()?;
        let body = if body.is_null() { String::new() } else { body.to_string() };
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nContent-Type: application/json; charset=utf-8\r\n\
             Content-Length: {}\r\nConnection: close\r\n\r\n{body}",
            self.port,
            body.len()
        )
        .ok()?;
        // the connection stays open whatever is asked for: the length tells the end
        let mut reader = BufReader::new(stream);
        let mut length = 0;
        loop {
            let mut line = String::new();
            if reader.read_line(&mut line).ok()? == 0 || line == "\r\n" {
                break;
            }
            match line.split_once(':') {
                Some((name, value)) if name.eq_ignore_ascii_case("content-length") => {
                    length = value.trim().parse().ok()?;
                }
                _ => {}
            }
        }
        let mut json = vec![0; length];
        reader.read_exact(&mut json).ok()?;
        serde_json::from_slice::<Value>(&json).ok().map(|answer| answer["value"].clone())
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        if !self.session.is_empty() {
            let _ = self.try_request("DELETE", &format!("/session/{}", self.session), &Value::Null);
        }
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}

fn moved(x: f64, y: f64) -> Value {
    json!({ "type": "pointerMove", "duration": 0, "x": x.round(), "y": y.round(), "origin": "viewport" })
}

fn which(program: &str) -> Option<std::path::PathBuf> {
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(program)).find(|path| path.is_file())
}

fn is_there(program: &str) -> bool {
    which(program).is_some()
}

/// Waits until something holds.
pub(crate) fn wait(what: &str, holds: impl Fn() -> bool) {
    let start = Instant::now();
    while !holds() {
        assert!(start.elapsed() < PATIENCE, "waited in vain: {what}");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// Opens a page on the widest screen and uses it: it fits, nothing is loaded from elsewhere, the console has no error, every figure that stands open is
/// drawn, the first curve of the first can be hidden by a click on its name and shown again, and the pointer reads a value
/// with its unit.
pub(crate) fn use_page(browser: &Browser, page: &Path, with_curves: bool) {
    let (name, width) = (page.display(), looks::SCREENS[0].0);
    browser.resize(width);
    browser.open(page);
    assert_ne!(browser.script("return document.querySelector('h1').textContent"), "", "{name}");
    let numbers = browser.script("return document.querySelectorAll('.number .value').length");
    assert!(numbers.as_u64() > Some(0), "{name}: no number stands at the top");
    assert!(
        with_curves
            == (browser.script("return document.querySelectorAll('.plot').length").as_u64() > Some(0)),
        "{name}: curves"
    );
    if with_curves {
        draw_all(browser, &name.to_string());
        hide_a_curve(browser, &name.to_string());
        read_a_value(browser, &name.to_string());
    }
    looks::fits(browser, &name.to_string(), width);
    let loaded = browser.script(
        "return performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:') && !n.startsWith('blob:'))",
    );
    assert_eq!(loaded, json!([]), "{name}: something was loaded");
    assert_eq!(browser.console_errors(), Vec::<String>::new(), "{name}: errors on the console");
    if let Some(folder) = std::env::var_os("KEEP_SCREENSHOTS_IN") {
        let stem = page.parent().and_then(Path::file_name).unwrap_or_default().to_string_lossy().into_owned();
        std::fs::write(Path::new(&folder).join(stem + ".base64"), browser.screenshot())
            .expect("kept for looking");
    }
}

/// Comes past every figure that is not folded up.
fn draw_all(browser: &Browser, name: &str) {
    let open = "Array.from(document.querySelectorAll('.plot')).filter(p => p.offsetParent && !p.closest('details:not([open])'))";
    let count = browser.script(&format!("return {open}.length")).as_u64().expect("a number");
    for figure in 0..count {
        browser.script(&format!("{open}[{figure}].scrollIntoView({{behavior: 'instant', block: 'center'}})"));
        wait(&format!("{name}: figure {figure} is drawn"), || {
            browser.script(&format!("return {open}[{figure}].dataset.ready === 'yes'")) == true
        });
    }
}

/// The first figure with a legend and lines in a plane.
const FIRST: &str = "Array.from(document.querySelectorAll('figure:not(.shapes) > .plot')).find(p => !p.closest('details:not([open])') && p.querySelector('.legendtoggle'))";

fn hide_a_curve(browser: &Browser, name: &str) {
    if browser.script(&format!("return Boolean({FIRST})")) != true {
        return;
    }
    browser.script(&format!(
        "const p = {FIRST}; p.id = 'chosen'; p.scrollIntoView({{behavior: 'instant', block: 'start'}})"
    ));
    let hidden = "const p = document.querySelector('#chosen'); \
                  return p.data.filter(t => t.legendgroup === p.data[0].legendgroup).every(t => t.visible === 'legendonly')";
    for (wanted, what) in [(true, "hides"), (false, "shows")] {
        browser.click("#chosen .legendtoggle");
        wait(&format!("{name}: a click on its name {what} a curve"), || browser.script(hidden) == wanted);
    }
}

fn read_a_value(browser: &Browser, name: &str) {
    if browser.script("return Boolean(document.querySelector('#chosen'))") != true {
        return;
    }
    // a finite point in the middle of the first curve, where it is in the window
    let point = browser.script(
        "const p = document.querySelector('#chosen'), t = p.data[0], l = p._fullLayout; \
         const x = l[t.xaxis.replace('x', 'xaxis')], y = l[t.yaxis.replace('y', 'yaxis')]; \
         const finite = t.x.map((_, i) => i).filter(i => t.x[i] !== null && t.y[i] !== null); \
         const i = finite[Math.floor(finite.length / 2)], b = p.getBoundingClientRect(); \
         return [b.x + x._offset + x.l2p(t.x[i]), b.y + y._offset + y.l2p(t.y[i])]",
    );
    let [x, y] = [0, 1].map(|i| point[i].as_f64().expect("a place"));
    let read = "return Array.from(document.querySelectorAll('#chosen .hoverlayer text')).map(t => t.textContent).join(' ')";
    browser.hover(x, y);
    wait(&format!("{name}: the pointer reads a value"), || {
        browser
            .script(read)
            .as_str()
            .is_some_and(|text| text.contains(" = ") && text.contains(|c: char| c.is_ascii_digit()))
    });
}
